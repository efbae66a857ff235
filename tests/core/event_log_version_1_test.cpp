// Event logs of version 1: read as the events that they stand for, and every mistake refused.
#include <gtest/gtest.h>

#include <string>

#include "core/event_log_refusals.h"

namespace tyg::test {
namespace {

const std::string kHead =
    "# scene = scenes/my curtain.toml\n# columns = 20\n# rows = 30\n# integrator = rk4\n# dt = 0.002\n"
    "# precision = float\n# ticks = 1000000000000\n# hash = 00ff12ab34cd56ef\n"
    "tick,event,particle,fx,fy,fz,ticks,method,dt\n";
const std::string kLog =
    kHead + "0,push,599,0.1,-0.33333333333333331,0,50,,\n7,method,,,,,,leapfrog,\n7,step,,,,,,,0.1\n";

TEST(EventLogVersion1, PushMethodAndStepAreRead) {
  const EventLog log = parseEventLog(kLog, "log");
  EXPECT_EQ(log.columns, 20);
  EXPECT_EQ(log.hash, "00ff12ab34cd56ef");
  const std::vector<Event> events = {
      {0, PushEvent{599, {0.1, -1.0 / 3, 0}, 50}}, {7, MethodEvent{"leapfrog"}}, {7, StepEvent{0.1}}};
  EXPECT_EQ(log.events, events);
}

TEST(EventLogVersion1, ChangesOfTheWorldBecomeOneEventForEachParameter) {
  const EventLog log = parseEventLog(kHead +
                                         "3,structural,,1200,0.1,,,,\n3,gravity,,0,-1.62,0.5,,,\n"
                                         "4,drag,,0.25,,,,,\n5,tolerance,,1e-06,,,,,\n",
                                     "log");
  const std::vector<Event> events = {{3, WorldEvent{"springs.structural.ks", {1200, 0, 0}}},
                                     {3, WorldEvent{"springs.structural.kd", {0.1, 0, 0}}},
                                     {3, WorldEvent{"world.gravity", {0, -1.62, 0.5}}},
                                     {4, WorldEvent{"world.drag", {0.25, 0, 0}}},
                                     {5, WorldEvent{"run.tolerance", {1e-6, 0, 0}}}};
  EXPECT_EQ(log.events, events);
}

TEST(EventLogVersion1, MistakesAreRefusedWithTheirLine) {
  expectRefusals(
      kLog, {
                {9, "tick,event",
                 "my.log:9: line: found 'tick,event', allowed '# key = value', or the line tick,event,particle"},
                {9, "tick,event,...", "my.log:9: line: found 'tick,event,...', allowed '# key = value', or"},
                {10, "", "my.log:10: line: found '', allowed nine fields"},
                {10, "0,push,1,0,0,1,50,", "my.log:10: line: found '0,push,1,0,0,1,50,', allowed nine fields"},
                {10, "0,poke,1,0,0,1,50,,", "my.log:10: event: found 'poke', allowed push, method, step, structural"},
                {10, "-1,push,1,0,0,1,50,,", "my.log:10: tick: found '-1', allowed a whole number from 0"},
                {10, "0.5,push,1,0,0,1,50,,", "my.log:10: tick: found '0.5', allowed a whole number"},
                {10, "0,push,600,0,0,1,50,,", "my.log:10: particle: found '600', allowed a whole number from 0 to 599"},
                {10, "0,push,1,0,nan,1,50,,", "my.log:10: fy: found 'nan', allowed a finite number"},
                {10, "0,push,1,0,0,,50,,", "my.log:10: fz: found '', allowed a finite number"},
                {10, "0,push,1,0,0,1,0,,", "my.log:10: ticks: found '0', allowed a whole number from 1"},
                {10, "0,push,1,0,0,1,50,rk4,", "my.log:10: field 8: found 'rk4', allowed nothing"},
                {11, "7,method,,,,,,,", "my.log:11: method: found '', allowed a name"},
                {11, "7,method,3,,,,,rk4,", "my.log:11: field 3: found '3', allowed nothing"},
                {11, "7,drag,,-1,,,,,", "my.log:11: fx: found '-1', allowed a finite number from 0"},
                {11, "7,drag,,1,2,,,,", "my.log:11: field 5: found '2', allowed nothing"},
                {11, "7,tolerance,,0,,,,,", "my.log:11: fx: found '0', allowed a finite number above 0"},
                {11, "7,bend,,200,,,,,", "my.log:11: fy: found '', allowed a finite number"},
                {12, "7,step,,,,,,,-0.1", "my.log:12: dt: found '-0.1', allowed a finite number above 0"},
                {13, "6,step,,,,,,,0.1", "my.log:13: tick: found '6', allowed a whole number from 7"},
            });
}

}  // namespace
}  // namespace tyg::test
