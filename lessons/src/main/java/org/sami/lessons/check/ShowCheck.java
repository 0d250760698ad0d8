package org.sami.lessons.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.LessonDomain;
import org.sami.lessons.course.Step;
import org.sami.lessons.script.EditScript;
import org.sami.lessons.script.SamePlan;
import org.sami.lessons.script.ScriptRun;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Plays what a step shows to its end with what the lesson's window has, and compares the plan with the result that the step names. */
final class ShowCheck {
    private ShowCheck() {}

    /**
     * Findings with pointers in the file of the lesson; none where all of it can be played.
     *
     * @param domain the whole domain
     */
    static List<Finding> check(Course course, Lesson lesson, Step.Show show, String pointer, DomainLibrary domain) {
        Reading<EditScript> script = EditScript.read(show.script(), pointer + "/script");
        Optional<Project> start = course.project(lesson.id(), show.plan());
        if (script.result().isEmpty() || start.isEmpty()) {
            return script.findings();
        }
        List<Finding> findings = new ArrayList<>();
        ScriptRun run = script.orThrow()
                .applyTo(start.get(), LessonDomain.of(course, lesson.id()).of(domain));
        run.refusal()
                .ifPresent(refusal -> findings.add(
                        Finding.error("E-LESSON", pointer + "/script" + refusal.pointer(), refusal.message())));
        if (run.refusal().isEmpty()) {
            LessonProblems problems = new LessonProblems();
            UseCheck.used(
                    course, lesson, run.project(), "what \"" + show.id() + "\" draws", pointer + "/script", problems);
            findings.addAll(problems.findings());
            show.result()
                    .flatMap(result -> course.project(lesson.id(), result))
                    .flatMap(result -> SamePlan.difference(run.project(), result))
                    .ifPresent(difference -> findings.add(Finding.error(
                            "E-LESSON",
                            pointer + "/result",
                            "what \"" + show.id() + "\" shows ends otherwise than its result (there): " + difference)));
        }
        return findings;
    }
}
