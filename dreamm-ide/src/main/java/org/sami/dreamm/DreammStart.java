package org.sami.dreamm;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.file.UnsavedWork;
import org.sami.dreamm.learn.LoadedCourse;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.lessons.course.CourseFiles;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/** Opens the window over the first project, or with the course, on the main thread, which may wait. */
final class DreammStart {
    private DreammStart() {}

    /** Opens it; the process ends with the window. */
    static void open(DreammOptions options, FirstProject first, AuthorDirectory data) throws IOException {
        open(options, first, data, System::exit);
    }

    /**
     * Opens it.
     *
     * @param ended is called when the window was closed
     */
    static DreammWindow open(DreammOptions options, FirstProject first, AuthorDirectory data, IntConsumer ended)
            throws IOException {
        return begin(options, first, data, CourseFiles.SHIPPED, ended).window();
    }

    /**
     * Opens the first window of a process.
     *
     * @param files the course that can be opened
     * @param ended is called when the last window was closed
     */
    static DreammSession begin(
            DreammOptions options, FirstProject first, AuthorDirectory data, CourseFiles files, IntConsumer ended)
            throws IOException {
        boolean isNew =
                data.isNew() && options.open().isEmpty() && options.profile().isWhole();
        List<UnsavedWork> left = RecoveryFolder.leftBehind(data.recovery());
        RecoveryFolder recovery =
                RecoveryFolder.take(data.recovery(), first.domain().vocabulary());
        WindowSettings settings = new WindowSettings(data.settings());
        DreammSession session = new DreammSession(options, first, data, files, settings, ended);
        Optional<LoadedCourse> course = options.learn().wanted()
                ? Optional.of(session.readCourse(options.learn().learner()))
                : Optional.empty();
        DreammWindow window = EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            DreammWindow made =
                    course.isPresent() ? session.openCourse(course.get(), recovery) : session.openFirst(recovery);
            if (course.isPresent() || made.unknownInProfile().isEmpty()) {
                made.files().offer(left);
                if (isNew && course.isEmpty() && session.whyNot().isEmpty()) {
                    offerCourse(made, session);
                }
            }
            return made;
        });
        if (course.isEmpty() && window.unknownInProfile().isPresent()) {
            throw new IOException(window.unknownInProfile().get());
        }
        return session;
    }

    private static void offerCourse(DreammWindow window, DreammSession session) {
        window.context()
                .questions()
                .ask(new AuthorQuestion(
                        "learn-offer",
                        "New here? The course teaches you to write plans in DREAMM itself, step by step. The menu Learn opens it at any time.",
                        List.of(
                                new AuthorQuestion.Choice("learn-offer-yes", "Open the course", session::enter),
                                new AuthorQuestion.Choice("learn-offer-no", "Not now", () -> {})),
                        () -> {}));
    }
}
