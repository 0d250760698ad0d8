package org.sami.dreamm;

import java.awt.Rectangle;
import java.awt.Robot;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.start.LearnOptions;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;
import org.sami.palette.Theme;
import org.sami.ui.check.WindowRobot;

/** Pictures of lessons as a learner has them: a step to read, a quiz, a job whose plan was checked, a final plan. */
final class LessonPictures {
    private static final String LEARNER = "Ada";

    private final Path pictures;
    private final Path data;

    /**
     * A picture.
     *
     * @param at where the learner is
     * @param commands what is done before, by command ids
     */
    private record Scene(String name, StepAddress at, List<String> commands) {}

    private static final List<Scene> SCENES = List.of(
            scene("lesson-2", "02-places", "job-visit", List.of()),
            scene("lesson-5", "05-requirements", "job-move", List.of("learn-check")),
            scene("lesson-9", "09-tasks", "job-measure", List.of("learn-check", "learn-hint")),
            scene("lesson-final", "final-panoramas", "job-apart", List.of()));

    LessonPictures(Path pictures, Path data) {
        this.pictures = pictures;
        this.data = data;
    }

    private static Scene scene(String name, String lesson, String step, List<String> commands) {
        return new Scene(name, new StepAddress(lesson, step), commands);
    }

    void take() throws Exception {
        for (Scene scene : SCENES) {
            take(scene);
        }
    }

    private void take(Scene scene) throws Exception {
        WindowRobot robot = new WindowRobot();
        new Learners(AuthorDirectory.open(data).learners())
                .keep(LearnerProgress.of(LEARNER).movedTo(scene.at()));
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        DreammSession session = open(ended);
        robot.untilShown("learn-step");
        for (String command : scene.commands()) {
            WindowRobot.ask(() -> {
                session.window().context().commands().get(command).run();
                return null;
            });
            if (command.equals("learn-check")) {
                robot.untilShown("learn-verdict");
            }
        }
        Rectangle bounds = WindowRobot.still(() -> new Rectangle(
                session.window().frame().getRootPane().getLocationOnScreen(),
                session.window().frame().getRootPane().getSize()));
        Path file = pictures.resolve("dreamm-" + scene.name() + ".png");
        ImageIO.write(new Robot().createScreenCapture(bounds), "png", file.toFile());
        System.out.printf(Locale.ROOT, "%s%n", file);
        WindowRobot.ask(() -> {
            session.window().end();
            return null;
        });
        ended.get(300, TimeUnit.SECONDS);
    }

    private DreammSession open(CompletableFuture<Integer> ended) throws IOException {
        DreammOptions options = new DreammOptions(
                Optional.empty(),
                Optional.empty(),
                Profile.ALL,
                Optional.of(Theme.LIGHT),
                Optional.of(100),
                new LearnOptions(true, Optional.of(LEARNER)));
        return DreammStart.begin(
                options, FirstProject.open(options), AuthorDirectory.open(data), CourseFiles.SHIPPED, ended::complete);
    }
}
