package org.sami.lessons.check;

import java.util.Collection;
import java.util.Optional;
import java.util.Set;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Picture;
import org.sami.lessons.course.TokensAt;
import org.sami.spn.model.Plan;

/** Finds pictures of plans that are not there, and marks and tokens on elements that the plan lacks. */
final class PictureCheck {
    private PictureCheck() {}

    static void check(Course course, Lesson lesson, Picture picture, String pointer, LessonProblems problems) {
        Optional<Plan> found = course.plan(lesson.id(), picture.plan());
        if (found.isEmpty()) {
            problems.add(pointer + "/plan", "there is no plan \"" + picture.plan() + "\"");
            return;
        }
        Plan plan = found.get();
        elements(plan, picture.mark(), pointer + "/mark", problems);
        for (int i = 0; i < picture.tokens().size(); i++) {
            place(plan, picture.tokens().get(i), pointer + "/tokens/" + i, problems);
        }
    }

    /** Every id is that of an element of the plan. */
    static void elements(Plan plan, Collection<String> ids, String pointer, LessonProblems problems) {
        Set<String> there = plan.elementIds();
        ids.stream()
                .filter(id -> !there.contains(id))
                .forEach(id -> problems.add(pointer, "the plan \"" + plan.id() + "\" has no element \"" + id + "\""));
    }

    static void place(Plan plan, TokensAt tokens, String pointer, LessonProblems problems) {
        if (plan.place(tokens.place()).isEmpty()) {
            problems.add(pointer, "the plan \"" + plan.id() + "\" has no place \"" + tokens.place() + "\"");
        }
    }
}
