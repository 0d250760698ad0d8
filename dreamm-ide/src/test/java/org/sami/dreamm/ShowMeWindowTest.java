package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_S;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.learn.show.ShowMe;
import org.sami.dreamm.learn.show.ShowMeModel;
import org.sami.dreamm.profile.Profile;
import org.sami.lessons.script.EditScript;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.check.WindowRobot;

/** Edits are played in the real window on a copy, and the author's own project comes back as it was. */
@Tag("window")
class ShowMeWindowTest {
    private static final String SCRIPT = """
            [{"do": "add", "item": "palette-event-start-system-timer", "at": [220, 100], "id": "wait", "event": "timer",
              "sequence": "alone", "say": "A timer."},
             {"do": "field", "event": "timer", "field": "duration", "source": {"value": "PT20S"}, "say": "It runs 20 s."},
             {"do": "add", "item": "palette-blank-transition", "at": [140, 100], "id": "begin"},
             {"do": "connect", "from": "start", "to": "begin"},
             {"do": "connect", "from": "begin", "to": "wait", "id": "out"},
             {"do": "require", "edge": "out", "requirements": [{"kind": "generic", "action": "take", "n": 1}]},
             {"do": "rename", "what": "wait", "name": "Wait"},
             {"do": "end", "what": "wait"}]
            """;

    private static Project copy() {
        Plan plan = new PlanBuilder("shown").start("start").at("start", 60, 100).build();
        return new Project("shown", "", "crw", List.of(), List.of(), List.of(plan));
    }

    @Test
    void aScriptIsPlayedToItsEndAndTheAuthorsProjectComesBackWithItsHistory(@TempDir Path data) throws Exception {
        try (AuthorRobot author = AuthorRobot.open(data, Optional.of("clv"), Optional.empty(), Profile.ALL)) {
            ShowMe show = WindowRobot.ask(() -> new ShowMe(author.window().context()));
            pauseStepAndSave(author, show);
            playToTheEnd(author, show);
        }
    }

    private static void start(AuthorRobot author, ShowMe show, ShowMeModel.Speed speed, Runnable onEnd) {
        EditScript script = EditScript.read("s.json", SCRIPT).orThrow();
        WindowRobot.ask(() -> {
            show.start(author.window().frame().getRootPane(), copy(), script, onEnd);
            show.model().ifPresent(model -> model.setSpeed(speed));
            return true;
        });
        author.robot.untilShown("show-bar");
    }

    private static void pauseStepAndSave(AuthorRobot author, ShowMe show) {
        WindowRobot robot = author.robot;
        Project mine = WindowRobot.ask(author.document()::project);
        JList<?> palette = author.palette();
        start(author, show, ShowMeModel.Speed.NORMAL, () -> {});
        robot.until("the palette has the item marked", () -> palette.getSelectedIndex() > 0);
        robot.press(VK_SPACE);
        robot.until("it stays", () -> !show.model().orElseThrow().isMoving());
        int at = WindowRobot.ask(() -> show.model().orElseThrow().done());
        robot.click("show-forward");
        robot.click("show-forward");
        robot.until("one edit is made", () -> show.model().orElseThrow().done() > at);
        robot.click("show-back");
        robot.until("it is taken back", () -> show.model().orElseThrow().done() == at);

        WindowRobot.ask(() -> {
            author.window().files().guard(() -> {});
            return true;
        });
        assertThat(WindowRobot.ask(show::isShown))
                .as("what would lose work ends the show first")
                .isFalse();
        assertThat(WindowRobot.ask(author.document()::project)).isSameAs(mine);
    }

    private static void playToTheEnd(AuthorRobot author, ShowMe show) {
        WindowRobot robot = author.robot;
        ProjectDocument document = author.document();
        DreammContext context = author.window().context();
        AtomicInteger ended = new AtomicInteger();
        Project mine = WindowRobot.ask(() -> {
            document.apply(new ProjectEdit.NameProject("My own"));
            return document.project();
        });
        Optional<String> plan = WindowRobot.ask(() -> context.editor().planId());

        start(author, show, ShowMeModel.Speed.FAST, ended::incrementAndGet);
        robot.press(VK_S, VK_CONTROL); // neither saves nor ends it
        robot.press(VK_DELETE);
        robot.until(
                "all is shown",
                () -> show.model()
                        .filter(model -> model.isAtEnd() && !model.isMoving())
                        .isPresent());

        Project shown = EditScript.read("s.json", SCRIPT)
                .orThrow()
                .applyTo(copy(), context.domain())
                .orThrow();
        assertThat(WindowRobot.ask(document::project)).isEqualTo(shown);
        assertThat(robot.find(JLabel.class, "show-title").getText()).isEqualTo("Show me: 8 of 8");

        robot.press(VK_ESCAPE);
        robot.until("it is over", () -> !show.isShown());
        assertThat(ended).hasValue(1);
        assertThat(WindowRobot.ask(document::project)).isSameAs(mine);
        assertThat(WindowRobot.ask(document::isModified)).isTrue();
        assertThat(WindowRobot.ask(() -> context.editor().planId())).isEqualTo(plan);
        assertThat(WindowRobot.ask(document::undoLabel)).contains("Name project");
    }
}
