package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DOWN;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_F;
import static java.awt.event.KeyEvent.VK_F2;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_Q;
import static java.awt.event.KeyEvent.VK_S;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_Z;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JTextField;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.palette.Theme;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** Drives the real window by keys and pointer: one window for all, as docking is for one a process. */
@Tag("window")
class DreammWindowTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final CompletableFuture<Integer> ended = new CompletableFuture<>();

    @Test
    void aProjectIsOpenedEditedSavedAndReadBackEqualByKeys(@TempDir Path folder) throws Exception {
        RealDisplay.assumed();
        Path file = folder.resolve("clv.json");
        new ProjectWriter(DOMAIN.vocabulary()).write(DOMAIN.projectOf("clv").orElseThrow(), file);
        DreammOptions options = new DreammOptions(
                Optional.of(file.toString()),
                Optional.empty(),
                Profile.ALL,
                Optional.of(Theme.LIGHT),
                Optional.of(100));
        DreammWindow window = DreammStart.open(
                options, FirstProject.open(options), AuthorDirectory.open(folder.resolve("data")), ended::complete);
        ProjectDocument document = window.context().document();
        WindowRobot robot = new WindowRobot();

        robot.find(JTextField.class, "palette-search");
        robot.press(VK_N, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("name-bar-name");
        robot.type("second plan");
        robot.press(VK_ENTER);
        robot.until("the plan is made", () -> document.plan("second-plan").isPresent());
        robot.press(VK_Z, VK_CONTROL);
        robot.until("the plan is taken back", () -> document.plan("second-plan").isEmpty());
        robot.press(VK_Z, VK_CONTROL, VK_SHIFT);
        robot.until("the plan is made again", () -> document.plan("second-plan").isPresent());
        WindowRobot.ask(() -> {
            window.context().editor().open("second-plan");
            return null;
        });
        robot.press(VK_F2);
        robot.untilFocused("name-bar-name");
        robot.type("third plan");
        robot.press(VK_ENTER);
        robot.until(
                "the plan is renamed",
                () -> document.plan("second-plan")
                        .filter(plan -> plan.name().equals("third plan"))
                        .isPresent());
        assertThat(WindowRobot.ask(document::isModified)).isTrue();
        robot.press(VK_S, VK_CONTROL);
        robot.untilSaid("notice", "Saved in");
        assertThat(read(file)).isEqualTo(WindowRobot.ask(document::project));

        robot.press(VK_F, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("search-everything-text");
        robot.type("select boats");
        robot.press(VK_DOWN);
        robot.until(
                "what was found is shown",
                () -> window.context().editor().planId().equals(Optional.of("clv")));

        Files.writeString(file, Files.readString(file).replace("third plan", "plan of another program"));
        robot.click("disk-load");
        robot.until(
                "the other program's plan is loaded",
                () -> document.plan("second-plan")
                        .filter(plan -> plan.name().equals("plan of another program"))
                        .isPresent());

        robot.press(VK_Z, VK_CONTROL);
        robot.until("the change is taken back", document::isModified);
        Project mine = WindowRobot.ask(document::project);
        robot.press(VK_Q, VK_CONTROL);
        robot.click("unsaved-save");

        assertThat(ended.get(300, TimeUnit.SECONDS)).isZero();
        assertThat(read(file)).isEqualTo(mine);
    }

    private static Project read(Path file) {
        return new ProjectReader(DOMAIN.vocabulary()).read(file).orThrow();
    }
}
