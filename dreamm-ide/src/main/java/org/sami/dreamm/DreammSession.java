package org.sami.dreamm;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.learn.CourseAccess;
import org.sami.dreamm.learn.Learning;
import org.sami.dreamm.learn.LessonListener;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.LoadedCourse;
import org.sami.dreamm.learn.mode.LessonProfile;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.dreamm.window.FramePlace;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.LessonDomain;
import org.sami.lessons.course.Term;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.progress.Learners;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.ui.EventThread;
import org.sami.ui.window.WindowSettings;

/**
 * The windows of a process, one at a time: that of an author, and those of the course, which is opened again with each lesson, in the lesson's mode and at the same
 * place. On the event thread, but where it says otherwise.
 */
final class DreammSession implements CourseAccess, LessonListener {
    private static final String LEARNER = "learner";

    private final DreammOptions options;
    private final FirstProject first;
    private final AuthorDirectory data;
    private final CourseFiles files;
    private final WindowSettings settings;
    private final IntConsumer ended;
    private Optional<DreammWindow> window = Optional.empty();
    private Optional<LessonModel> lesson = Optional.empty();
    private Optional<JobGrader> grader = Optional.empty();

    DreammSession(
            DreammOptions options,
            FirstProject first,
            AuthorDirectory data,
            CourseFiles files,
            WindowSettings settings,
            IntConsumer ended) {
        this.options = Objects.requireNonNull(options, "options");
        this.first = Objects.requireNonNull(first, "first");
        this.data = Objects.requireNonNull(data, "data");
        this.files = Objects.requireNonNull(files, "files");
        this.settings = Objects.requireNonNull(settings, "settings");
        this.ended = Objects.requireNonNull(ended, "ended");
    }

    /** The window that is open. */
    DreammWindow window() {
        return window.orElseThrow(() -> new IllegalStateException("no window was opened yet"));
    }

    /**
     * Reads the course and a learner's progress; on any thread.
     *
     * @throws IOException if that cannot be, with the reason in a sentence
     */
    LoadedCourse readCourse(Optional<String> named) throws IOException {
        String learner = named.orElseGet(this::lastLearner);
        return LoadedCourse.read(files, first.domain(), new Learners(data.learners()), learner);
    }

    /** Who learned last on this machine, else its user. */
    private String lastLearner() {
        String last = settings.text(LEARNER);
        String user = System.getProperty("user.name", "");
        return Learners.NAME.matcher(last).matches()
                ? last
                : Learners.NAME.matcher(user).matches() ? user : LEARNER;
    }

    // ---- The author's window

    /** Opens the author's window. */
    DreammWindow openFirst(RecoveryFolder recovery) {
        DreammContext context = new DreammContext(first.source(), first.domain(), first.document(), options.profile());
        first.plan().ifPresent(context.editor()::open);
        return open(context, recovery);
    }

    private DreammWindow open(DreammContext context, RecoveryFolder recovery) {
        context.maps().remember(settings.text("map-last"), text -> settings.keep("map-last", text));
        Optional<FramePlace> place = window.map(DreammWindow::place);
        window.ifPresent(DreammWindow::discard); // of docked panels a process has one set at a time
        DreammWindow made =
                new DreammWindow(context, recovery, data, settings, this::end, new Learning(lesson, grader, this));
        if (made.unknownInProfile().isPresent() && lesson.isEmpty()) {
            made.discard();
            return made;
        }
        window = Optional.of(made);
        place.ifPresentOrElse(made::openAt, made::open);
        return made;
    }

    private void end(int code) {
        lesson.ifPresent(model -> model.record().close());
        ended.accept(code);
    }

    // ---- The course

    @Override
    public Optional<String> whyNot() {
        return options.domain().isEmpty()
                ? Optional.empty()
                : Optional.of("the course is about the robots of the domain that ships, not about " + first.source());
    }

    @Override
    public Reading<Glossary> glossary() {
        return Glossary.read(files);
    }

    @Override
    public void explain(Term term) {
        lesson.ifPresentOrElse(model -> goTo(model, term), () -> enterAt(Optional.of(term)));
    }

    private static void goTo(LessonModel model, Term term) {
        model.course().address(term.lesson(), term.step()).ifPresent(model::go);
    }

    @Override
    public void enter() {
        enterAt(Optional.empty());
    }

    private void enterAt(Optional<Term> explained) {
        DreammWindow now = window();
        now.files()
                .guard(() -> now.context()
                        .background()
                        .run(
                                "Opening the course",
                                () -> {
                                    try {
                                        return readCourse(Optional.empty());
                                    } catch (IOException none) {
                                        throw new UncheckedIOException(none.getMessage(), none);
                                    }
                                },
                                course -> {
                                    explained.ifPresent(term -> goTo(course.model(), term));
                                    withRecovery(recovery -> openCourse(course, recovery));
                                }));
    }

    /** What a window is opened with. */
    private interface Opening {
        void with(RecoveryFolder recovery);
    }

    private void withRecovery(Opening opening) {
        RecoveryFolder recovery;
        try {
            recovery = RecoveryFolder.take(data.recovery(), first.domain().vocabulary());
        } catch (IOException full) {
            window().context().notices().refused("another window cannot be opened: " + full.getMessage());
            return;
        }
        opening.with(recovery);
    }

    /** Opens the window of the lesson at which a learner is. */
    DreammWindow openCourse(LoadedCourse course, RecoveryFolder recovery) {
        LessonModel model = course.model();
        lesson = Optional.of(model);
        grader = Optional.of(new JobGrader(model.course(), first.domain()));
        settings.keep(LEARNER, model.record().learner());
        model.addListener(this);
        DreammWindow made = openLesson(model, recovery);
        model.record()
                .whenFailed(why ->
                        EventThread.later(() -> window().context().notices().refused(why)));
        course.notes().forEach(made.context().notices()::refused);
        return made;
    }

    private DreammWindow openLesson(LessonModel model, RecoveryFolder recovery) {
        DomainLibrary domain =
                LessonDomain.of(model.course(), model.lesson().id()).of(first.domain());
        ProjectDocument document = new ProjectDocument(
                domain.vocabulary(),
                new Project(
                        "course",
                        model.lesson().title(),
                        domain.vocabulary().domain(),
                        List.of(),
                        List.of(),
                        List.of()),
                Optional.empty());
        return open(new DreammContext(first.source(), domain, document, LessonProfile.of(model.lesson())), recovery);
    }

    @Override
    public void lessonChanged() {
        lesson.ifPresent(model -> withRecovery(recovery -> openLesson(model, recovery)));
    }

    @Override
    public void leave() {
        lesson.ifPresent(model -> {
            model.removeListener(this);
            model.record().close();
        });
        lesson = Optional.empty();
        grader = Optional.empty();
        withRecovery(recovery -> open(
                new DreammContext(
                        first.source(),
                        first.domain(),
                        new ProjectDocument(
                                first.domain().vocabulary(), LibraryProject.of(first.domain()), Optional.empty()),
                        Profile.ALL),
                recovery));
    }
}
