package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_2;
import static java.awt.event.KeyEvent.VK_6;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_F11;
import static java.awt.event.KeyEvent.VK_F5;
import static java.awt.event.KeyEvent.VK_F6;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_O;
import static java.awt.event.KeyEvent.VK_S;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_Z;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.ui.check.WindowRobot;

/**
 * Station keeping from nothing, as the author's guide has it: by palette, wizard, editors and edges that are drawn; all of it undone and done
 * again, tried, kept as a case, saved, opened again, and run by the installed command.
 */
@Tag("window")
class StationKeepWindowTest {
    /** The project after each edit, the one before the first in front. */
    private final List<String> states = new ArrayList<>();

    @Test
    void planIsDrawnUndoneTriedSavedOpenedAgainAndRun(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("station.json");
        try (AuthorRobot author =
                AuthorRobot.open(folder.resolve("data"), Optional.empty(), Optional.empty(), Profile.ALL)) {
            begin(author);
            draw(author);
            author.robot.untilSaid("count-errors", "0");
            author.robot.untilSaid("count-warnings", "0");
            assertThat(author.plan().variables()).extracting(v -> v.name()).containsExactly("@points");
            undoAndRedo(author);
            tryIt(author);
            saveAndOpenAgain(author, file);
        }
        Crw.Outcome ran = Crw.run(folder, List.of("run", file.toString(), "--area", "100", "--speed", "max"));
        assertThat(ran.code()).as(ran.said()).isZero();
        assertThat(ran.said()).contains("outcome             ended");
    }

    private void begin(AuthorRobot author) {
        author.robot.press(VK_N, VK_CONTROL);
        author.robot.until(
                "a new project is open",
                () -> author.document().project().plans().size() == 1
                        && author.window().context().editor().plan().isPresent());
        states.add(author.text());
        author.document().addListener(change -> {
            if (change.cause() == DocumentChange.Cause.EDITED) {
                states.add(new ProjectWriter(author.document().vocabulary())
                        .text(author.document().project()));
            }
        });
    }

    private static void draw(AuthorRobot author) {
        author.add("select boat list", "Operator Select Boat List");
        author.click(author.behind("OperatorSelectsBoatList"));
        author.add("assemble location", "Assemble Location Request");
        author.click(author.behind("AssembleLocationResponse"));
        author.add("goto point", "Proxy Goto Point");
        author.click(author.place("AssembleLocationRequest"));
        author.write("inspector-name", "Gather");
        author.robot.choose("field-location-source", "asked, can be changed");
        author.robot.choose("field-spacing-source", "asked, can be changed");
        author.write("value-spacing-text", "10");

        author.click(author.behind("ProxyPathCompleted"));
        author.add("station keep", "Proxy Station Keep");
        String stay = author.place("ProxyStationKeep");
        author.click(stay);
        author.add("start system timer", "Start System Timer");
        author.robot.choose("field-duration-source", "value");
        author.write("value-duration-text", "1 min");

        String drifted = author.plan().inEdges().stream()
                .filter(e -> e.place().equals(stay) && !e.transition().equals(author.transition("TimerExpired")))
                .map(e -> e.transition())
                .findFirst()
                .orElseThrow();
        backToThePoint(author, drifted);
        author.click(author.behind("TimerExpired"));
        author.tick("inspector-end");
        author.click(author.behind("ProxyPathFailed"));
        author.pattern(VK_2); // until none is left
    }

    /** A boat that cannot stay goes there again instead of to a place of its own: an edge is drawn, its requirement chosen. */
    private static void backToThePoint(AuthorRobot author, String drifted) {
        String unused = author.plan().outEdges().stream()
                .filter(e -> e.transition().equals(drifted))
                .map(e -> e.place())
                .findFirst()
                .orElseThrow();
        author.click(unused);
        author.robot.press(VK_DELETE);
        author.robot.until(
                "the place is gone",
                () -> author.document().project().plans().get(0).place(unused).isEmpty());
        String goTo = author.place("ProxyGotoPoint");
        author.move(drifted, 0, -120); // an edge back along the same line would be hidden
        author.connect(drifted, goTo);
        author.clickEdge(drifted, goTo);
        author.robot.click("inspector-add-requirement");
        author.robot.choose("inspector-kind-0", "Relevant");
    }

    /** Each edit is taken back and made again to the bytes that were there. */
    private void undoAndRedo(AuthorRobot author) {
        int edits = states.size() - 1;
        assertThat(edits).isGreaterThan(15);
        for (int i = edits - 1; i >= 0; i--) {
            author.robot.press(VK_Z, VK_CONTROL);
            String before = states.get(i);
            author.robot.until("edit " + (i + 1) + " is taken back", () -> before.equals(text(author)));
        }
        assertThat(WindowRobot.ask(() -> author.document().undoLabel())).isEmpty();
        for (int i = 1; i <= edits; i++) {
            author.robot.press(VK_Z, VK_CONTROL, VK_SHIFT);
            String after = states.get(i);
            author.robot.until("edit " + i + " is made again", () -> after.equals(text(author)));
        }
        assertThat(WindowRobot.ask(() -> author.document().redoLabel())).isEmpty();
    }

    private static String text(AuthorRobot author) {
        return new ProjectWriter(author.document().vocabulary())
                .text(author.document().project());
    }

    private static void tryIt(AuthorRobot author) {
        author.robot.press(VK_6, VK_ALT);
        author.robot.untilShown("try-out-panel");
        author.robot.press(VK_F5);
        author.robot.untilSaid("try-where", "step 0");
        JLabel where = author.robot.find(JLabel.class, "try-where");
        int steps = 0;
        while (!WindowRobot.ask(() -> where.getText().contains("over: "))) {
            assertThat(++steps).as(WindowRobot.ask(where::getText)).isLessThan(40);
            author.robot.press(VK_F6);
            author.robot.untilSaid("try-where", "step " + steps);
        }
        assertThat(WindowRobot.ask(where::getText)).contains("over: ended");
        author.tab("try-tab-cases");
        author.write("case-name", "all goes well");
        author.robot.until(
                "the run is kept",
                () -> author.document().project().plans().get(0).testCases().size() == 1);
        author.robot.press(VK_F11, VK_CONTROL);
        author.robot.untilSaid("cases-message", "1 passed, 0 failed");
    }

    private static void saveAndOpenAgain(AuthorRobot author, Path file) {
        author.robot.press(VK_S, VK_CONTROL);
        author.giveFile(file);
        author.robot.untilSaid("notice", "Saved in");
        Project drawn = WindowRobot.ask(() -> author.document().project());
        assertThat(author.read(file)).isEqualTo(drawn);
        assertThat(drawn.plans().get(0).testCases()).extracting(TestCase::name).containsExactly("all goes well");

        author.robot.press(VK_N, VK_CONTROL);
        author.robot.until(
                "another project is open", () -> author.document().file().isEmpty());
        author.robot.press(VK_O, VK_CONTROL);
        author.giveFile(file);
        author.robot.until("the file is open", () -> author.document().file().isPresent());
        assertThat(WindowRobot.ask(() -> author.document().project())).isEqualTo(drawn);
        assertThat(WindowRobot.ask(author.document()::isModified)).isFalse();
    }
}
