package org.sami.lessons.course;

import java.util.List;

/**
 * What of the window is hidden and locked while a lesson is taken (thesis, appendix .4.1): patterns of ids, as in a profile of DREAMM.
 *
 * @param hide what is not shown
 * @param lock what is shown and cannot be used
 * @param keep what is there in full although another pattern hides or locks it
 */
public record LessonMode(List<String> hide, List<String> lock, List<String> keep) {
    public LessonMode {
        hide = Absent.orNone(hide);
        lock = Absent.orNone(lock);
        keep = Absent.orNone(keep);
    }

    private record ProfileJson(
            int formatVersion, String name, List<String> hide, List<String> lock, List<String> keep) {}

    /** The mode as the text of a profile, for who wants the same window without the lesson. */
    public String profile(String name) {
        return LessonJson.write(new ProfileJson(1, name, hide, lock, keep));
    }
}
