package org.sami.lessons.job;

import java.util.List;
import java.util.function.Function;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** The small course with two jobs of the tests: one with an operator and a variable, one with tasks. */
final class JobCourse {
    static final String LESSON = "01-jobs";
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    static final Course COURSE = read();
    static final JobGrader GRADER = new JobGrader(COURSE, DOMAIN);

    private JobCourse() {}

    private static Course read() {
        Reading<Course> read = CourseReader.read(CourseFiles.onClassPath("org/sami/lessons/course-of-jobs"), DOMAIN);
        if (read.hasErrors()) {
            throw new AssertionError(read.findings());
        }
        return read.orThrow();
    }

    static Job job(String id) {
        Reading<Job> read = JobReader.read(COURSE, LESSON, id, DOMAIN.vocabulary());
        if (read.result().isEmpty()) {
            throw new AssertionError(read.findings());
        }
        return read.orThrow();
    }

    static Project solution(String job) {
        return COURSE.project(LESSON, job).orElseThrow();
    }

    static Project start(String job) {
        return COURSE.project(LESSON, job + "-0").orElseThrow();
    }

    static Verdict grade(String job, Project project) {
        return GRADER.grade(LESSON, job(job), project);
    }

    /** The project with its first plan changed. */
    static Project with(Project project, Function<Plan, Plan> change) {
        return project.withPlans(List.of(change.apply(project.plans().get(0))));
    }

    static Plan requiring(Plan plan, String inEdge, InRequirement... requirements) {
        return plan.withInEdges(plan.inEdges().stream()
                .map(edge -> edge.id().equals(inEdge) ? edge.withRequirements(List.of(requirements)) : edge)
                .toList());
    }

    static Plan taking(Plan plan, String outEdge, OutRequirement... requirements) {
        return plan.withOutEdges(plan.outEdges().stream()
                .map(edge -> edge.id().equals(outEdge) ? edge.withRequirements(List.of(requirements)) : edge)
                .toList());
    }

    static Plan without(Plan plan, String edge) {
        List<InEdge> ins =
                plan.inEdges().stream().filter(one -> !one.id().equals(edge)).toList();
        List<OutEdge> outs =
                plan.outEdges().stream().filter(one -> !one.id().equals(edge)).toList();
        return plan.withInEdges(ins).withOutEdges(outs);
    }
}
