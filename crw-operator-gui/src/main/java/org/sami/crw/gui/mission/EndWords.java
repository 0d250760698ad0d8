package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.crw.gui.boat.CommandWords;
import org.sami.crw.operator.MissionEnd;
import org.sami.crw.operator.MissionEnd.BoatChange;
import org.sami.crw.operator.MissionSnapshot;

/** What an abort or a completion will do, in lines. */
final class EndWords {
    private static final int BOATS_NAMED = 6;

    private EndWords() {}

    /** The lines; never none. */
    static List<String> lines(MissionEnd end, Optional<String> interceptor) {
        List<String> lines = new ArrayList<>();
        interceptor.ifPresent(name -> lines.add("The plan has a transition for it, " + name
                + ": what it draws comes first. What follows comes when the mission ends."));
        end.boats().stream().limit(BOATS_NAMED).forEach(boat -> lines.add(line(boat)));
        if (end.boats().size() > BOATS_NAMED) {
            lines.add("… and " + (end.boats().size() - BOATS_NAMED) + " more boats lose what it wants of them");
        }
        if (end.boats().isEmpty()) {
            lines.add("No boat stops: it wants nothing of any boat now.");
        }
        if (!end.decisions().isEmpty()) {
            lines.add(count(end.decisions().size(), "decision") + " withdrawn: "
                    + end.decisions().stream()
                            .map(one -> one.presentation().title())
                            .collect(Collectors.joining(", ")));
        }
        if (!end.subMissions().isEmpty()) {
            lines.add(count(end.subMissions().size(), "sub-mission") + " ended as well: "
                    + end.subMissions().stream()
                            .map(MissionSnapshot::title)
                            .distinct()
                            .collect(Collectors.joining(", ")));
        }
        return lines;
    }

    private static String line(BoatChange boat) {
        String loses = boat.inForce()
                .map(entry -> " no longer has to " + CommandWords.progress(entry))
                .orElse(" loses "
                        + (boat.waiting() == 1 ? "a command that waits" : boat.waiting() + " commands that wait"));
        String then = boat.next()
                .map(entry -> boat.inForce().isPresent()
                        ? ", and goes on with: " + CommandWords.what(entry.command()) + ", for "
                                + CommandWords.whose(entry.command())
                        : ", and goes on as it does")
                .orElse(", and stops: nobody else wants anything of it");
        return boat.boat() + loses + then;
    }

    private static String count(int number, String what) {
        return number == 1 ? "1 " + what + " is" : number + " " + what + "s are";
    }
}
