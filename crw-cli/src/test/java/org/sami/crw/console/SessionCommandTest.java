package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/** {@code crw session} as its user has it: a script of commands, real boats behind real sockets on the loopback address. */
@Tag("long")
class SessionCommandTest {
    private static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);
    private static final String NEAR = "45.40003,10.90003"; // 4 m from the pier

    /** One plan that waits for an interrupt, and a global variable. */
    private static final String LAKE = """
        {
          "formatVersion": 1,
          "id": "lake",
          "name": "Lake",
          "domain": "crw",
          "globals": [{"name": "@depth", "type": "real", "initial": 2.5}],
          "plans": [
            {
              "id": "wait",
              "name": "Wait",
              "places": [
                {"id": "here", "name": "Here", "start": true},
                {"id": "end", "name": "End", "end": true}
              ],
              "transitions": [
                {
                  "id": "go",
                  "name": "Go",
                  "inputs": [
                    {"id": "go-on", "type": "OperatorInterruptReceived", "fields": {"interruptName": "go on"}}
                  ]
                }
              ],
              "inEdges": [
                {"id": "i", "place": "here", "transition": "go", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}
              ],
              "outEdges": [
                {"id": "o", "transition": "go", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]}
              ]
            }
          ]
        }
        """;

    @TempDir
    Path folder;

    private int scripts;

    private static BoatOnTcp boat(String name) throws IOException {
        return robot(name, RobotKind.BOAT);
    }

    private static BoatOnTcp robot(String name, RobotKind kind) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        return new BoatOnTcp(
                BoatSettings.of(name, anyPort, PIER, 1).of(kind),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE);
    }

    private static String address(BoatOnTcp boat) {
        return "127.0.0.1:" + boat.address().getPort();
    }

    private CommandResult session(List<String> options, String... commands) throws IOException {
        Path script = Files.write(folder.resolve("script" + scripts++), List.of(commands));
        List<String> arguments = new ArrayList<>(List.of("session", "--script", script.toString()));
        arguments.addAll(options);
        return CommandResult.crw(arguments.toArray(new String[0]));
    }

    @Test
    void missionIsStartedAnsweredAndDrivenToItsEndByCommands() throws IOException {
        try (BoatOnTcp anna = boat("anna");
                BoatOnTcp bo = boat("bo")) {
            CommandResult ran = session(
                    List.of("--connect", address(anna)),
                    "connect " + address(bo) + " # while it runs",
                    "wait boats 2 within 120",
                    "boats",
                    "start clv",
                    "wait decision within 120",
                    "decisions",
                    "answer all",
                    "wait decision within 120",
                    "answer " + NEAR,
                    "wait decision within 120",
                    "answer 1",
                    "missions",
                    "why 1",
                    "wait ended within 120",
                    "quit");

            assertThat(ran.out())
                    .contains("anna is linked", "bo is linked", "mission 1 of clv has begun")
                    .containsPattern("1 or more of (anna, bo|bo, anna), or all")
                    .contains("1  clv  runs since", "mission 1 of clv: ended", "All boats have finished");
            assertThat(ran.out()).doesNotContain("crw: ");
            assertThat(ran.exitCode()).isZero();
        }
    }

    /** The options name both boats; the mission of whom is left goes on, and the operator is told who is missing. */
    @Test
    void boatThatIsDroppedWhileOptionsNameItIsNotWaitedFor() throws IOException {
        CommandResult ran = session(
                List.of(),
                "add b 45.7,10.72 2",
                "wait boats 2 within 120",
                "start clv",
                "wait decision within 120",
                "answer all",
                "wait decision within 120",
                "answer 45.7001,10.7201;45.7002,10.7202",
                "wait decision within 120",
                "drop b2",
                "answer 1",
                "wait ended within 120",
                "quit");

        assertThat(ran.out())
                .contains("OperatorAcceptedAllocation is taken without b2, who is gone")
                .contains("All boats have finished", "mission 1 of clv: ended");
        assertThat(ran.exitCode()).isZero();
    }

    @Test
    void boatThatNeverAnsweredIsListedCountedAndGivenUp() throws IOException {
        int nobodys;
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            nobodys = taken.getLocalPort();
        }
        try (BoatOnTcp anna = boat("anna")) {
            CommandResult ran = session(
                    List.of("--connect", address(anna) + ",127.0.0.1:" + nobodys),
                    "wait boats 1 within 120",
                    "wait 3",
                    "boats",
                    "disconnect 127.0.0.1:" + nobodys,
                    "quit");

            assertThat(ran.out())
                    .containsPattern("127.0.0.1:" + nobodys
                            + "  link connecting  127.0.0.1:" + nobodys
                            + " no answer · connection refused · tried \\d+ times in \\d")
                    .contains("1 of 2 boats linked")
                    .contains("127.0.0.1:" + nobodys + " is given up");
            assertThat(ran.exitCode()).isZero();
        }
    }

    @Test
    void commandThatCannotBeCarriedOutIsExplainedAndTheNextOneIsRead() throws IOException {
        CommandResult ran = session(
                List.of(),
                "strat clv",
                "start clvv",
                "start clv speed",
                "start clv @nothing=3",
                "answer yes",
                "why 7",
                "why anna",
                "abort 7",
                "press alarm",
                "take anna",
                "connect nowhere",
                "add x 100,200",
                "drive anna 2 0",
                "wait boats many",
                "set @x 3",
                "help quit extra",
                "say 'hello",
                "help start",
                "quit");

        assertThat(ran.out().lines().filter(line -> line.startsWith("crw: ")))
                .hasSize(17)
                .anyMatch(line -> line.contains("is start meant?"))
                .anyMatch(line -> line.contains("there is no plan 'clvv'; there are "))
                .anyMatch(line -> line.contains("'nowhere' is no HOST:PORT"))
                .anyMatch(line -> line.contains("no mission 7 runs"))
                .anyMatch(line -> line.contains("there is no boat 'anna'"));
        assertThat(ran.out()).contains("start PLAN [NAME=VALUE ...]");
        assertThat(ran.exitCode()).isEqualTo(6);
    }

    @Test
    void sessionGoesOnFromItsJournalWithMissionsAndBoats() throws IOException {
        String journal = folder.resolve("session.journal").toString();
        try (BoatOnTcp anna = boat("anna")) {
            CommandResult first = session(
                    List.of("station-keep", "--journal", journal, "--connect", address(anna)),
                    "wait boats 1 within 120",
                    "start station-keep",
                    "wait decision within 120");
            assertThat(first.exitCode()).as(first.out() + first.err()).isZero();

            CommandResult second = session(
                    List.of("--journal", journal),
                    "wait boats 1 within 120",
                    "missions",
                    "decisions",
                    "abort 1",
                    "wait ended within 120");

            assertThat(second.out())
                    .contains("going on with " + journal + ", with anna", "1  station-keep  runs since", "[1] ")
                    .contains("mission 1 of station-keep: aborted");
            assertThat(second.exitCode()).as(second.out()).isZero();
        }
    }

    @Test
    void boatIsDrivenByHandGivenBackStoppedAndDropped() throws IOException {
        try (BoatOnTcp anna = boat("anna")) {
            CommandResult ran = session(
                    List.of("--connect", address(anna)),
                    "wait boats 1 within 120",
                    "drive anna 0.5 0 1",
                    "back anna",
                    "stop all",
                    "release all",
                    "stop anna",
                    "release anna",
                    "watch anna",
                    "take anna",
                    "why anna",
                    "drop anna",
                    "boats");

            assertThat(ran.out())
                    .contains("anna was driven for 1 s", "FLEET STOP: anna", "released: anna", "there is no boat");
            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        }
    }

    @Test
    void boatThatIsStoppedIsNotSaidToBeDriven() throws IOException {
        try (BoatOnTcp anna = boat("anna")) {
            CommandResult ran = session(
                    List.of("--connect", address(anna)),
                    "wait boats 1 within 120",
                    "stop all",
                    "drive anna 0.5 0 1",
                    "release all");

            assertThat(ran.out() + ran.err())
                    .contains("anna is stopped, release it first")
                    .doesNotContain("was driven");
        }
    }

    @Test
    void copterIsNotDrivenByHand() throws IOException {
        try (BoatOnTcp copter = robot("kite", RobotKind.COPTER)) {
            CommandResult ran = session(
                    List.of("--domain", "uav", "--connect", address(copter)),
                    "wait boats 1 within 120",
                    "drive kite 0.5 0 1",
                    "boats");

            assertThat(ran.out() + ran.err())
                    .contains("kite flies, and is not flown by hand from here: its own radio control takes it over")
                    .doesNotContain("was driven");
        }
    }

    @Test
    void mendedProjectIsLoadedBesideARunningMissionAndGlobalsAreSaved() throws IOException {
        Path project = Files.writeString(folder.resolve("lake.json"), LAKE);
        Path mended = Files.writeString(folder.resolve("mended.json"), LAKE.replace("\"End\"", "\"The end\""));
        Path broken = Files.writeString(folder.resolve("broken.json"), LAKE.replace("\"plans\"", "\"plan\""));

        CommandResult ran = session(
                List.of(project.toString()),
                "start wait",
                "set @depth 4",
                "load " + broken,
                "load " + mended,
                "start wait",
                "globals",
                "save " + project,
                "save " + project,
                "save " + folder.resolve("none.json"),
                "abort all",
                "wait ended within 120");

        assertThat(ran.out())
                .contains("mission 1 of wait has begun", "mission 2 of wait has begun", "as project 2; ")
                .contains("@depth = 4", "saved to " + project, project + " has these values already")
                .contains("crw: the project is not loaded: ", "crw: there is no file ");
        assertThat(ran.out().lines().filter(line -> line.startsWith("crw: "))).hasSize(2);
        assertThat(project).content().contains("\"initial\": 4");
    }

    @Test
    void simulatedBoatsAreAdded() throws IOException {
        CommandResult ran = session(List.of(), "add sim 45.4,10.9 2", "wait boats 2 within 120", "boats");

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out()).contains("sim").contains("is linked");
    }

    @Test
    void fenceNotesAndLogSurviveTheProcessAndAlarmsAreAcknowledged() throws IOException {
        String journal = folder.resolve("log.journal").toString();
        CommandResult first = session(
                List.of("station-keep", "--journal", journal),
                "add sim 45.4,10.9",
                "wait boats 1 within 120",
                "note weeds at 45.41,10.91",
                "fence 45.5,10.9;45.5,11;45.6,11",
                "wait alarm within 120",
                "alarms",
                "ack a1",
                "mute a1",
                "alarms",
                "stop all");
        CommandResult second = session(List.of("--journal", journal), "log", "fence", "fence none", "fence");

        assertThat(first.out())
                .contains("ALARM: sim is outside of the water in which boats may go", "a1  critical  sim is outside")
                .contains("alarm a1 is acknowledged", ", acknowledged, muted", "noted at 45.41000,10.91000");
        assertThat(first.exitCode()).as(first.out() + first.err()).isZero();
        assertThat(second.out())
                .contains("note  weeds  at 45.41000,10.91000", "fence  set the fence: 3 corners")
                .contains("acknowledged  sim is outside of the water", "fleet stop  stopped the fleet")
                .contains("fence: 3 corners; no-go areas: 0", "there is no fence; no-go areas: 0");
        assertThat(second.exitCode()).as(second.out() + second.err()).isZero();
    }

    @Test
    void deploymentsProjectHasItsFenceAndLayersAreSwitchedByHand() throws IOException {
        Path project = Files.writeString(
                folder.resolve("beach.json"),
                LAKE.replace("{\"name\": \"@depth\", \"type\": \"real\", \"initial\": 2.5}", """
                    {"name": "@water", "type": "area", "initial": {"outline": [
                      {"lat": 45.3, "lon": 10.8}, {"lat": 45.3, "lon": 11}, {"lat": 45.5, "lon": 11}]}},
                    {"name": "@noGo", "type": "list<area>", "initial": [{"outline": [
                      {"lat": 45.31, "lon": 10.9}, {"lat": 45.31, "lon": 10.95}, {"lat": 45.33, "lon": 10.95}]}]}
                    """));

        CommandResult ran = session(
                List.of(project.toString()),
                "fence",
                "fence none",
                "fence",
                "fence project",
                "fence",
                "layers boat-state on",
                "layers",
                "layers boat-state auto",
                "layers");

        assertThat(ran.out())
                .contains("@water: 3 corners; no-go areas: 1", "there is no fence; no-go areas: 1")
                .contains("boat-state  on, by hand", "boat-state  off", "2 areas");
        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
    }

    @Test
    void taskIsMovedToAnotherBoatOrRefused() throws IOException {
        try (BoatOnTcp anna = boat("anna");
                BoatOnTcp bo = boat("bo")) {
            CommandResult ran = session(
                    List.of("measure", "--connect", address(anna) + "," + address(bo)),
                    "wait boats 2 within 120",
                    "start measure make-tasks.taskClass=Temperature measuring.duration=5s",
                    "wait decision within 120",
                    "answer 45.401,10.901;45.4011,10.9011",
                    "wait tasks within 120",
                    "allocation",
                    "move \"1/Temperature 1\" nowhere",
                    "move \"1/Temperature 9\" bo",
                    "move \"1/Temperature 1\" bo",
                    "move \"1/Temperature 1\" anna",
                    "allocation",
                    "log",
                    "abort all",
                    "wait ended within 120");

            assertThat(ran.out())
                    .contains(
                            "crw: there is no boat 'nowhere'; there are ",
                            "crw: there is no open task '1/Temperature 9'")
                    .contains("1/Temperature 1 is anna's now")
                    .containsPattern("task {2}moved task Temperature 1 to anna");
        }
    }

    @Test
    void wrongOptionsAreRefusedBeforeASessionIsOpened() {
        assertThat(CommandResult.crw("session", "--connect", "nowhere").exitCode())
                .isEqualTo(2);
        assertThat(CommandResult.crw("session", "no-such-plan").exitCode()).isEqualTo(2);
        assertThat(CommandResult.crw("session", "--script", "no-such-file").err())
                .contains("no-such-file");
    }
}
