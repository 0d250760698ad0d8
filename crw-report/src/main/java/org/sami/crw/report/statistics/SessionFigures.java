package org.sami.crw.report.statistics;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * What one journal says about its session, or several about theirs.
 *
 * @param journals number of journals
 * @param millis sum of the times from the first entry to the last
 * @param clicks all clicks of the operator, also those that belong to no mission
 * @param decisions all questions, also those of the domain
 * @param missions in the order in which they started
 * @param remarks what was left out as it is damaged, in sentences
 */
public record SessionFigures(
        int journals, long millis, long clicks, int decisions, List<MissionFigures> missions, List<String> remarks) {
    /** Nothing yet. */
    public static final SessionFigures NONE = new SessionFigures(0, 0, 0, 0, List.of(), List.of());

    public SessionFigures {
        missions = List.copyOf(missions);
        remarks = List.copyOf(remarks);
    }

    /** Both together. */
    public SessionFigures with(SessionFigures other) {
        Objects.requireNonNull(other, "other");
        List<MissionFigures> all = new ArrayList<>(missions);
        all.addAll(other.missions);
        List<String> both = new ArrayList<>(remarks);
        both.addAll(other.remarks);
        return new SessionFigures(
                journals + other.journals,
                millis + other.millis,
                clicks + other.clicks,
                decisions + other.decisions,
                all,
                both);
    }

    /** The operator's load: clicks in a minute of the sessions. */
    public double clicksPerMinute() {
        return millis == 0 ? 0 : clicks * 60_000.0 / millis;
    }
}
