package org.sami.dreamm.learn;

import java.util.List;
import org.sami.lessons.course.Lesson;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.Project;

/** The projects that lie in the editor beside a lesson. */
public final class LessonDesk {
    private LessonDesk() {}

    /** An empty plan, on which a learner tries what a lesson says. */
    public static Project empty(Lesson lesson, String domain) {
        return new Project(
                "practice",
                "Practice: " + lesson.title(),
                domain,
                List.of(),
                List.of(),
                List.of(new PlanBuilder("practice").build()));
    }
}
