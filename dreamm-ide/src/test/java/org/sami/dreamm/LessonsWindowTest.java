package org.sami.dreamm;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.lessons.job.Job;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.job.JobReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * A learner takes the course that ships in the real window, each lesson in its mode: lessons 2 and 5 from their first step to their last, and
 * one job of each other lesson and final plan. With {@code -Plessons=whole} lessons 7 and 9 and both final plans are taken whole as well. One window
 * serves them all.
 */
@Tag("window")
class LessonsWindowTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Course COURSE =
            CourseReader.read(CourseFiles.SHIPPED, DOMAIN).orThrow();
    private static final JobGrader GRADER = new JobGrader(COURSE, DOMAIN);

    /** Those of which each step is taken: quizzes of all kinds, pictures that play, jobs. */
    private static final Set<String> WHOLE = Boolean.getBoolean("lessons.whole")
            ? Set.of("02-places", "05-requirements", "07-operator", "09-tasks", "final-panoramas", "final-exploration")
            : Set.of("02-places", "05-requirements");

    /** The job that is done of each other lesson. */
    private static final Set<String> JOBS = Set.of(
            "events-buoy",
            "add-gust",
            "latecomers",
            "ask-first",
            "two-fields",
            "measure",
            "system-allocates",
            "return-values",
            "lost-robot",
            "let-pass",
            "panoramas-together",
            "avoid-the-ferry");

    /** The commands that do something to the elements that are selected. */
    private static final Set<String> ABOUT_ELEMENTS = Set.of(
            "net-rename",
            "net-delete",
            "net-cut",
            "net-copy",
            "net-duplicate",
            "net-connect",
            "net-append",
            "net-extract",
            "net-disable",
            "net-set-start",
            "net-set-end",
            "net-mark-recovery",
            "net-mark-nominal");

    @TempDir
    private static Path folder;

    private static LearnerRobot learner;

    @BeforeAll
    static void open() throws Exception {
        learner = LearnerRobot.open(folder, CourseFiles.SHIPPED, "ada");
    }

    @AfterAll
    static void close() throws Exception {
        if (learner != null) {
            learner.close();
        }
    }

    static Stream<String> lessons() {
        return COURSE.lessons().stream().map(Lesson::id).filter(id -> !id.equals("01-motivation"));
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void theLessonIsTakenByPaletteKeysAndEditorsInItsMode(String id) {
        Lesson lesson = COURSE.lesson(id).orElseThrow();
        StepGestures hand = new StepGestures(learner, COURSE, DOMAIN.vocabulary());
        List<Step> steps = lesson.steps().stream()
                .filter(step -> WHOLE.contains(id) || (step instanceof Step.Job job && JOBS.contains(job.job())))
                .toList();
        assertThat(steps).as("steps of " + id).isNotEmpty();
        hand.go(lesson, steps.get(0));
        for (Step step : steps) {
            if (step instanceof Step.Job job) {
                learner.untilStep(step.title());
                draw(id, job.job());
                onlyTaughtThingsAreVisible(lesson);
                assertThat(hand.checkPlan()).as(id + "/" + job.job()).startsWith("Passed");
                hand.next();
            } else {
                hand.take(lesson, step);
            }
        }
    }

    /** Looks at menus, palette and inspector, with each kind of element selected. */
    private static void onlyTaughtThingsAreVisible(Lesson lesson) {
        NetGestures net = new NetGestures(learner.robot, learner::context);
        List<String> order = COURSE.lessons().stream().map(Lesson::id).toList();
        Set<String> visible = new TreeSet<>(VisibleThings.now());
        Plan plan = net.plan();
        for (String vertex : oneOfEachKind(plan)) {
            net.click(vertex);
            visible.addAll(VisibleThings.now());
        }
        for (String edge :
                List.of(plan.inEdges().get(0).id(), plan.outEdges().get(0).id())) {
            net.clickEdge(edge);
            visible.addAll(VisibleThings.now());
            if (order.indexOf(lesson.id()) < order.indexOf("05-requirements")) {
                assertThat(VisibleThings.inspectorNow())
                        .as("what the inspector offers of an edge")
                        .isEmpty();
                assertThat(VisibleThings.commandsNow().stream().filter(ABOUT_ELEMENTS::contains))
                        .as("what can be done to an edge")
                        .containsExactly("net-delete");
            }
        }
        assertThat(visible.stream().flatMap(each -> Taught.whyNot(each, lesson.id(), COURSE).stream()))
                .as("what is seen in " + lesson.id())
                .isEmpty();
    }

    private static Set<String> oneOfEachKind(Plan plan) {
        Set<String> vertices = new LinkedHashSet<>();
        plan.places().stream()
                .filter(place -> !place.outputs().isEmpty())
                .findFirst()
                .ifPresent(place -> vertices.add(place.id()));
        plan.places().stream()
                .filter(place -> !place.subMissions().isEmpty())
                .findFirst()
                .ifPresent(place -> vertices.add(place.id()));
        plan.places().stream().filter(Place::end).findFirst().ifPresent(place -> vertices.add(place.id()));
        plan.transitions().stream()
                .filter(each -> !each.inputs().isEmpty())
                .findFirst()
                .ifPresent(each -> vertices.add(each.id()));
        plan.transitions().stream()
                .filter(each -> each.inputs().isEmpty())
                .findFirst()
                .ifPresent(each -> vertices.add(each.id()));
        return vertices;
    }

    private static void draw(String lesson, String name) {
        Job job = JobReader.read(COURSE, lesson, name, DOMAIN.vocabulary()).orThrow();
        Project solution = GRADER.solution(lesson, job).orThrow();
        String words = COURSE.jobs().get(lesson + "/" + name);
        new JobGestures(learner.robot, learner::context, String.valueOf(words)).draw(solution);
    }
}
