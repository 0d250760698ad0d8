package org.sami.crw.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.console.CommandLineText;
import org.sami.crw.console.ConsoleFault;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.crw.sim.run.settings.PlannedMission;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.TextNumbers;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A script that a run plays in place of a plan: commands of the console, one a line. {@code start} starts a mission, {@code press} presses an
 * interrupt, {@code wait SECONDS} lets simulated time pass. {@code wait ended} and {@code quit} may end it, as a run does so by itself; other
 * commands are refused. Faults name file and line.
 */
public final class RunScript {
    private static final String COMMANDS =
            "a run's script has start PLAN [NAME=VALUE ...], press INTERRUPT [BOAT ...] and wait SECONDS";

    private final Path file;
    private final List<Start> starts = new ArrayList<>();
    private final List<Press> presses = new ArrayList<>();
    private long nowMillis; // since the first mission's start
    private boolean ended;

    private record Start(int line, String plan, long atMillis, Map<String, String> values) {}

    private record Press(int line, String text) {}

    private RunScript(Path file) {
        this.file = file;
    }

    /**
     * Reads a script.
     *
     * @throws UsageFault naming the line where one makes no sense
     */
    public static RunScript read(Path file) {
        RunScript script = new RunScript(file);
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            try {
                script.take(i + 1, CommandLineText.words(lines.get(i)));
            } catch (ConsoleFault fault) {
                throw script.fault(i + 1, String.valueOf(fault.getMessage()));
            }
        }
        if (script.starts.isEmpty()) {
            throw new UsageFault("--script: " + file + " starts no mission; " + COMMANDS);
        }
        return script;
    }

    private static List<String> lines(Path file) {
        try {
            return BoundedFile.text(file, BoundedFile.DATA_BYTES).lines().toList();
        } catch (FileTooLargeException e) {
            throw new UsageFault("--script: " + e.getMessage());
        } catch (IOException e) {
            throw new UsageFault("--script: cannot read " + file);
        }
    }

    private UsageFault fault(int line, String message) {
        return new UsageFault(file + ":" + line + ": " + message);
    }

    private void take(int line, List<String> words) {
        if (words.isEmpty()) {
            return;
        }
        String command = words.get(0);
        List<String> rest = words.subList(1, words.size());
        if (command.equals("quit") && rest.isEmpty()) {
            ended = true;
        } else if (ended) {
            throw fault(line, "the script has ended above; a run is over when all of its missions are");
        } else if (command.equals("wait")) {
            await(line, rest);
        } else if (command.equals("start") && !rest.isEmpty()) {
            starts.add(new Start(line, rest.get(0), nowMillis, values(line, rest.subList(1, rest.size()))));
        } else if (command.equals("press") && !rest.isEmpty()) {
            press(line, rest);
        } else {
            throw fault(line, "'" + String.join(" ", words) + "' cannot be played in a run; " + COMMANDS);
        }
    }

    private void await(int line, List<String> rest) {
        OptionalLong millis = rest.size() == 1
                ? TextNumbers.real(rest.get(0), 0, RunSettings.LONGEST_MILLIS / 1000.0).stream()
                        .mapToLong(seconds -> Math.round(seconds * 1000))
                        .findFirst()
                : OptionalLong.empty();
        if (rest.equals(List.of("ended"))) {
            ended = true;
        } else if (millis.isEmpty()) {
            throw fault(line, "wait takes a number of seconds from 0 to 86400, not '" + String.join(" ", rest) + "'");
        } else if (starts.isEmpty()) {
            throw fault(line, "time counts from the start of the first mission; nothing has started to wait after");
        } else {
            nowMillis += millis.getAsLong();
        }
    }

    private Map<String, String> values(int line, List<String> words) {
        Map<String, String> values = new LinkedHashMap<>();
        for (String word : words) {
            int equals = word.indexOf('=');
            if (equals < 1) {
                throw fault(line, "'" + word + "' is no NAME=VALUE");
            }
            values.put(word.substring(0, equals), word.substring(equals + 1));
        }
        return values;
    }

    private void press(int line, List<String> words) {
        if (starts.isEmpty()) {
            throw fault(line, "no mission has started in which '" + words.get(0) + "' could be pressed");
        }
        if (words.contains("in")) {
            throw fault(line, "in a run an interrupt is pressed in every mission that offers it; leave out 'in'");
        }
        String at = "@" + nowMillis / 1000.0;
        if (words.size() == 1) {
            presses.add(new Press(line, words.get(0) + at));
        }
        words.stream().skip(1).forEach(boat -> presses.add(new Press(line, words.get(0) + ":" + boat + at)));
    }

    /**
     * The plans of all its missions, in its order.
     *
     * @throws UsageFault naming the line whose plan is not in the project, or does not take a value
     */
    public List<Plan> plans(Vocabulary vocabulary, Project project) {
        List<Plan> plans = new ArrayList<>();
        for (Start start : starts) {
            try {
                plans.add(PlannedMission.parse(text(start), vocabulary, project).plan());
            } catch (IllegalArgumentException unfit) {
                throw fault(start.line(), String.valueOf(unfit.getMessage()));
            }
        }
        return plans;
    }

    /**
     * Looks whether its interrupts fit the missions.
     *
     * @param boats names of the run's boats; empty where they are not known yet
     * @throws UsageFault naming the line whose interrupt no plan has, or whose boat there is not
     */
    public void check(PlanInterrupts interrupts, List<String> boats) {
        for (Press press : presses) {
            try {
                interrupts.read(List.of(press.text()), boats);
            } catch (IllegalArgumentException unfit) {
                throw fault(press.line(), String.valueOf(unfit.getMessage()));
            }
        }
    }

    /** Values for what the first mission's plan would ask. */
    public Map<String, String> parameters() {
        return starts.get(0).values();
    }

    /** The other missions, in the form of {@link RunSettings#also}. */
    public List<String> also() {
        return starts.stream().skip(1).map(RunScript::text).toList();
    }

    /** Its presses, in the form of {@link RunSettings#interrupts}. */
    public List<String> interrupts() {
        return presses.stream().map(Press::text).toList();
    }

    private static String text(Start start) {
        return PlannedMission.text(start.plan(), start.atMillis(), start.values());
    }
}
