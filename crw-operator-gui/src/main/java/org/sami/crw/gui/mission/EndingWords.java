package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.crw.gui.boat.CommandWords;
import org.sami.crw.operator.mission.MissionEnd;
import org.sami.crw.operator.mission.MissionEnd.BoatChange;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.proxy.explanation.MissionTitles;

/** What an abort or a completion will do, in lines. */
final class EndingWords {
    private EndingWords() {}

    /**
     * The lines; never none.
     *
     * @param titles names those whose commands come next
     */
    static List<String> lines(MissionEnd end, Optional<String> interceptor, MissionTitles titles) {
        List<String> lines = new ArrayList<>();
        interceptor.ifPresent(name -> lines.add("The plan has a transition for it, " + name
                + ": what it draws comes first. What follows comes when the mission ends."));
        List<BoatChange> stop = end.boats().stream().filter(EndingWords::stops).toList();
        if (!stop.isEmpty()) {
            lines.add(stop.stream().map(EndingWords::loses).collect(Collectors.joining(", "))
                    + (stop.size() == 1 ? " stops" : " stop") + ": nobody else wants anything of "
                    + (stop.size() == 1 ? "it." : "them."));
        }
        end.boats().stream().filter(boat -> !stops(boat)).forEach(boat -> lines.add(line(boat, titles)));
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

    private static boolean stops(BoatChange boat) {
        return boat.inForce().isPresent() && boat.next().isEmpty();
    }

    /** A boat and what it no longer does. */
    private static String loses(BoatChange boat) {
        return boat.boat()
                + boat.inForce()
                        .map(entry -> " (" + CommandWords.progress(entry) + ")")
                        .orElse("");
    }

    private static String line(BoatChange boat, MissionTitles titles) {
        String waiting = boat.waiting() == 1 ? "a command that waits" : boat.waiting() + " commands that wait";
        return boat.inForce().isPresent()
                ? loses(boat) + " goes on with: "
                        + boat.next()
                                .map(entry -> CommandWords.what(entry.command()) + ", for "
                                        + titles.words(entry.command().mission()))
                                .orElseThrow()
                : boat.boat() + " goes on as it does, and loses " + waiting;
    }

    private static String count(int number, String what) {
        return number == 1 ? "1 " + what + " is" : number + " " + what + "s are";
    }
}
