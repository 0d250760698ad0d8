package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_1;
import static java.awt.event.KeyEvent.VK_2;
import static java.awt.event.KeyEvent.VK_3;
import static java.awt.event.KeyEvent.VK_4;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_S;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.PlayedTasks;
import org.sami.spn.testing.PlayedTeam;

/**
 * The final plan of the thesis's study (9.1.2, Figures 9.6 and 9.7) from nothing, by palette, canvas, inspector and patterns: panoramas at
 * locations of the operator, each when its boat is there, and all at the same time. Both are saved and run with 1, 3 and 5 locations.
 */
@Tag("window")
class PanoramaWindowTest {
    private static final String EACH = "each-as-it-arrives";

    private static final int SEEDS = 10;

    @Test
    void bothPlansOfTheThesisAreDrawnFromNothingAndRunToTheirEnds(@TempDir Path folder) throws Exception {
        try (AuthorRobot author =
                AuthorRobot.open(folder.resolve("data"), Optional.empty(), Optional.empty(), Profile.ALL)) {
            begin(author);
            untilBoatsGo(author);
            author.addBehind("ProxyPathCompleted", "take panorama", "Take Panorama", EACH);
            untilTheEnd(author);
            runAsynchronously(author, saved(author, folder.resolve("asynchronous.json")));

            begin(author);
            untilBoatsGo(author);
            author.click(author.behind("ProxyPathCompleted"));
            author.pattern(VK_1); // when all are here
            author.click(author.named("All together"));
            author.add("take panorama", "Take Panorama", EACH);
            untilTheEnd(author);
            runSynchronously(author, saved(author, folder.resolve("synchronous.json")));
        }
    }

    private static void runAsynchronously(AuthorRobot author, Project drawn) {
        boolean overtaken = false;
        for (int[] run : new int[][] {{1, 1}, {3, 3}, {5, 5}, {5, 2}}) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                List<String> order = ran(author, drawn, run[0], run[1], seed);
                overtaken |= !order.equals(order.stream().sorted().toList());
            }
        }
        assertThat(overtaken)
                .as("some picture was taken before the last boat arrived")
                .isTrue();
    }

    private static void runSynchronously(AuthorRobot author, Project drawn) {
        for (int locations : new int[] {1, 3, 5}) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                assertThat(ran(author, drawn, locations, locations, seed)).isSorted();
            }
        }
    }

    private static void begin(AuthorRobot author) {
        author.robot.press(VK_N, VK_CONTROL);
        author.robot.until(
                "a new project is open",
                () -> author.document().project().plans().size() == 1
                        && author.document().file().isEmpty()
                        && author.window().context().editor().plan().isPresent()
                        && author.window()
                                .context()
                                .editor()
                                .plan()
                                .get()
                                .places()
                                .isEmpty());
    }

    /** The operator gives locations, tasks are made of them and allocated by autonomy, and each boat goes to the location of its task. */
    private static void untilBoatsGo(AuthorRobot author) {
        author.add("create locations", "Operator Create Locations");
        author.addBehind("OperatorCreatesLocations", "generate tasks", "Generate Tasks");
        author.robot.choose("field-task-class-source", "value");
        author.robot.choose("field-task-class-value", "Camera");
        author.addBehind("TasksGenerated", "allocation request", "Allocation Request");
        author.addBehind("AllocationResponse", "allocation options", "Operator Allocation Options");
        String options = author.place("OperatorAllocationOptions");
        author.click(options);
        author.pattern(VK_3); // autonomy decides at once
        author.click(options);
        author.pattern(VK_4); // ask again on no
        author.addBehind("OperatorAcceptedAllocation", "apply allocation", "Apply Allocation");
        author.add("task started", "Task Started");
        author.addBehind("TaskStarted", "goto lat lon", "Proxy Goto Lat Lon", EACH);
    }

    /** Each boat waits five seconds, its task is complete, and the mission ends when no task is left. */
    private static void untilTheEnd(AuthorRobot author) {
        author.addBehind("PanoramaTaken", "start proxy timer", "Start Proxy Timer");
        author.robot.choose("field-duration-source", "value");
        author.write("value-duration-text", "5 s");
        author.addBehind("ProxyTimerExpired", "task complete", "Task Complete");
        String complete = author.place("TaskComplete");
        author.lead("ProxyPathFailed", complete, 0, -80);
        author.lead("PanoramaFailed", complete, 0, 60);
        author.click(author.behind("TaskCompleted"));
        author.write("inspector-name", "Finished");
        author.pattern(VK_2); // until none is left
    }

    private static Project saved(AuthorRobot author, Path file) {
        author.robot.untilSaid("count-errors", "0");
        author.robot.untilSaid("count-warnings", "0");
        author.robot.press(VK_S, VK_CONTROL);
        author.giveFile(file);
        author.robot.untilSaid("notice", "Saved in");
        return author.read(file);
    }

    /** Runs a plan to its end; says in which order boats arrived ("1") and pictures were taken ("2"). */
    private static List<String> ran(AuthorRobot author, Project drawn, int locations, int boats, long seed) {
        PlayedTeam team = new PlayedTeam(drawn, author.document().vocabulary(), boats, seed)
                .decides(
                        "OperatorCreateLocations",
                        d -> new Answer.Fields(Map.of("locations", PlayedTasks.locations(locations))))
                .once(
                        "AllocationRequest",
                        "AllocationResponse",
                        a -> Map.of("allocations", PlayedTasks.allocations(a, boats)))
                .works("TaskStarted", "TaskComplete")
                .each("ProxyGotoLatLon", "ProxyPathCompleted")
                .each("TakePanorama", "PanoramaTaken")
                .each("TaskComplete", "TaskCompleted");

        assertThat(team.run(drawn.plans().get(0).id()))
                .as("%d locations, %d boats, seed %d", locations, boats, seed)
                .contains(Outcome.ENDED);
        String arrived = transition(drawn, "ProxyPathCompleted");
        String taken = transition(drawn, "PanoramaTaken");
        assertThat(team.fired(taken)).isEqualTo(locations);
        assertThat(team.fired(transition(drawn, "TaskCompleted"))).isEqualTo(locations);
        return team.firedOf(arrived, taken).stream()
                .map(t -> t.equals(arrived) ? "1" : "2")
                .toList();
    }

    private static String transition(Project project, String answer) {
        return project.plans().get(0).transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(answer)))
                .map(Transition::id)
                .findFirst()
                .orElseThrow();
    }
}
