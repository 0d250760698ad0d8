package org.sami.dreamm;

import java.awt.Rectangle;
import java.awt.Robot;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import javax.imageio.ImageIO;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.palette.Theme;
import org.sami.picture.net.NetMode;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.testing.TemporaryFolder;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;

/** Opens DREAMM and puts pictures of it into a folder: the net in its modes, an event's editor, issues, a run that is tried, lessons. */
public final class DreammScreenshotMain {
    private static final String PLAN = "clv-interrupts";
    private static final int STEPS = 6;

    private final Path pictures;
    private final DreammWindow window;
    private final CompletableFuture<Integer> ended = new CompletableFuture<>();

    private DreammScreenshotMain(Path pictures, Path data) throws IOException {
        this.pictures = pictures;
        DreammOptions options = new DreammOptions(
                Optional.of(PLAN), Optional.empty(), Profile.ALL, Optional.of(Theme.LIGHT), Optional.of(100));
        window = DreammStart.open(options, FirstProject.open(options), AuthorDirectory.open(data), ended::complete);
    }

    /** The first argument is the folder. */
    public static void main(String[] args) throws Exception {
        try (TemporaryFolder data = new TemporaryFolder("dreamm-pictures")) {
            new DreammScreenshotMain(Path.of(args[0]), data.path()).run();
            new LessonPictures(Path.of(args[0]), data.path()).take();
        }
        System.exit(0);
    }

    private void run() throws Exception {
        EditorState editor = window.context().editor();
        Plan plan = editor.plan().orElseThrow();
        picture("nominal");
        String place = plan.places().stream()
                .filter(p -> !p.outputs().isEmpty())
                .findFirst()
                .orElseThrow()
                .id();
        act(() -> editor.select(List.of(place)));
        picture("event-editor");
        act(() -> editor.select(Set.of()));
        act(() -> editor.setMode(NetMode.RECOVERY));
        command("net-fit"); // recovery parts lie below the nominal ones
        picture("recovery");
        String interrupt = plan.transitions().stream()
                .filter(t -> t.mode() == Mode.RECOVERY)
                .map(Transition::id)
                .findFirst()
                .orElse(plan.transitions().get(0).id());
        act(() -> editor.select(List.of(interrupt)));
        picture("recovery-selected");
        act(() -> editor.setMode(NetMode.NOMINAL));
        command("net-fit");
        act(() -> editor.select(Set.of()));
        pictureOfIssues(plan);
        command("panel-try-out");
        command("try-start");
        for (int i = 0; i < STEPS; i++) {
            command("try-step");
        }
        picture("try-it");
        act(window::end);
        ended.get(300, TimeUnit.SECONDS);
    }

    /** What is found where the events of the plan have lost what they read from variables. */
    private void pictureOfIssues(Plan plan) throws Exception {
        command("panel-issues");
        int edits = 0;
        for (Place place : plan.places()) {
            for (OutputEventSpec event : place.outputs()) {
                for (String field : event.fields().keySet()) {
                    act(() -> window.context().apply(new FieldEdit.ClearField(plan.id(), event.id(), field)));
                    edits++;
                }
            }
        }
        command("issue-next");
        picture("issues");
        for (int i = 0; i < edits; i++) {
            act(window.context()::undo);
        }
        act(() -> window.context().editor().select(Set.of()));
        act(() -> window.context().editor().highlight(Set.of()));
    }

    private void command(String command) {
        act(() -> window.context().commands().get(command).run());
    }

    private static void act(Runnable action) {
        WindowRobot.ask(() -> {
            action.run();
            return null;
        });
        pass(1);
    }

    private static void pass(int seconds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (System.nanoTime() < end) {
            LockSupport.parkNanos(end - System.nanoTime());
        }
    }

    private void picture(String scene) throws Exception {
        for (Theme theme : scene.equals("nominal") ? Theme.values() : new Theme[] {Theme.LIGHT}) {
            act(() -> Look.apply(theme, 100));
            Rectangle bounds = WindowRobot.ask(() -> new Rectangle(
                    window.frame().getRootPane().getLocationOnScreen(),
                    window.frame().getRootPane().getSize()));
            Path file = pictures.resolve("dreamm-" + scene + (theme == Theme.LIGHT ? "" : "-" + theme.id()) + ".png");
            ImageIO.write(new Robot().createScreenCapture(bounds), "png", file.toFile());
            System.out.printf(Locale.ROOT, "%s%n", file);
        }
        act(() -> Look.apply(Theme.LIGHT, 100));
    }
}
