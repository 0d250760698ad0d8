package org.sami.dreamm.learn.mode;

import java.util.ArrayList;
import java.util.List;
import org.sami.dreamm.profile.Profile;
import org.sami.lessons.course.Lesson;

/** The profile of a window in which a lesson is taken: what the lesson's mode says, and all that the course itself needs. */
public final class LessonProfile {
    /** What no lesson takes away: the course, help, the look, the way out. */
    private static final List<String> ALWAYS = List.of(
            "panel-learn",
            "learn-*",
            "show-*",
            "end",
            "theme-*",
            "scale-*",
            "rows-high",
            "command-search",
            "help-keys",
            "words-*",
            "panels-*");

    private LessonProfile() {}

    /** The profile of a lesson. */
    public static Profile of(Lesson lesson) {
        List<String> keep = new ArrayList<>(lesson.mode().keep());
        keep.addAll(ALWAYS);
        return new Profile(lesson.heading(), lesson.mode().hide(), lesson.mode().lock(), keep);
    }
}
