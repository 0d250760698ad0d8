package org.sami.crw.fleet;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts about boats as they read of copters: what is only true on the water by its own words, then driving as flying, then the word for a boat. What
 * stands in quotes is the user's, and stays as it is; so do command lines, and {@link RobotKind#SURFACE_BOAT}. */
final class CopterWords {
    /** Not within a name, an address or a path: boat-2, boat.local:5001 and /home/me/boats/x.log stay as they are. */
    private static final String BEFORE = "(?<![\\w./\\\\-])";

    private static final String AFTER = "(?!\\w|[-/\\\\]|[.:]\\w)";

    /** In double quotes, or in single ones that are no apostrophes. */
    private static final String QUOTED = "\"[^\"\\n]*\"|(?<!\\w)'[^'\\n]*'(?!\\w)";

    /** A command with its subcommand, options and what stands for their values, such as crw boat --mavlink ADDRESS. */
    private static final String COMMAND_LINE =
            "(?<![\\w./-])crw [a-z][a-z-]*(?: (?:--?[a-z][\\w-]*|[A-Z][A-Z:_]*)(?!\\w))*";

    private static final Pattern KEPT = Pattern.compile(QUOTED + "|" + COMMAND_LINE + "|"
            + RobotKind.OtherKind.BOAT_AMONG_COPTERS + "|\\b" + RobotKind.SURFACE_BOAT + "s?\\b");

    private static final Map<Pattern, String> WORDS = new LinkedHashMap<>(); // longer ones first

    static {
        put(", or start the plan that connects boats", ""); // their library has none
        put("through water in which boats may not go", "through an area in which copters may not fly");
        put("water in which boats may not go", "an area in which copters may not fly");
        put("outside of the water in which boats may go", "outside of the area in which copters may fly");
        put("back into its water", "back into its area");
        put("outside of their water", "outside of their area");
        put("stop their motors and drift", "stop and hover");
        put("stops its motors and drifts", "lands where it is"); // without a link
        put("its motors are stopped", "it is stopped");
        put("turn the hull", "turn it");
        put("Before launch", "Before take-off");
        put("may be launched", "may take off");
        put("where boats lay", "where copters stood");
        put("quay", "take-off place");
        put("rudder", "yaw");
        put("drive", "fly");
        put("drives", "flies");
        put("driven", "flown");
        put("driving", "flying");
        put("Drive", "Fly");
        put("Drives", "Flies");
        put("Driving", "Flying");
        put("boat", "copter");
        put("boats", "copters");
        put("Boat", "Copter");
        put("Boats", "Copters");
    }

    private CopterWords() {}

    private static void put(String ofBoats, String ofCopters) {
        put(WORDS, ofBoats, ofCopters);
    }

    /** Adds a word or phrase about boats and what stands in its place. */
    static void put(Map<Pattern, String> words, String ofBoats, String ofOthers) {
        words.put(Pattern.compile(BEFORE + Pattern.quote(ofBoats) + AFTER), Matcher.quoteReplacement(ofOthers));
    }

    /** The text, said of copters. */
    static String of(String text) {
        return of(text, WORDS);
    }

    /** The text with other words, apart from what stands in quotes, command lines, and what names one kind beside the other. */
    static String of(String text, Map<Pattern, String> words) {
        StringBuilder said = new StringBuilder();
        Matcher kept = KEPT.matcher(text);
        int end = 0;
        while (kept.find()) {
            said.append(replaced(text.substring(end, kept.start()), words)).append(kept.group());
            end = kept.end();
        }
        return said.append(replaced(text.substring(end), words)).toString();
    }

    private static String replaced(String text, Map<Pattern, String> words) {
        String said = text;
        for (Map.Entry<Pattern, String> word : words.entrySet()) {
            said = word.getKey().matcher(said).replaceAll(word.getValue());
        }
        return said;
    }
}
