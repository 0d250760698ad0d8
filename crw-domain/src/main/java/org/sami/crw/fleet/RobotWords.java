package org.sami.crw.fleet;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/** Texts about boats as they read of a fleet of boats and copters. */
final class RobotWords {
    private static final Map<Pattern, String> WORDS = new LinkedHashMap<>(); // longer ones first

    static {
        put(", or start the plan that connects boats", ""); // their library has none
        put("through water in which boats may not go", "through an area in which robots may not go");
        put("water in which boats may not go", "an area in which robots may not go");
        put("outside of the water in which boats may go", "outside of the area in which robots may go");
        put("back into its water", "back into its area");
        put("outside of their water", "outside of their area");
        put("stop their motors and drift", "stop");
        put("stops its motors and drifts", "stops its motors and drifts, or lands if it flies"); // without a link
        put("its motors are stopped", "it is stopped");
        put("turn the hull", "turn it");
        put("where boats lay", "where robots stood");
        put("drive", "move");
        put("drives", "moves");
        put("driven", "moved");
        put("driving", "moving");
        put("Drive", "Move");
        put("Drives", "Moves");
        put("Driving", "Moving");
        put("boat", "robot");
        put("boats", "robots");
        put("Boat", "Robot");
        put("Boats", "Robots");
    }

    private RobotWords() {}

    private static void put(String ofBoats, String ofRobots) {
        CopterWords.put(WORDS, ofBoats, ofRobots);
    }

    /** The text, said of robots. */
    static String of(String text) {
        return CopterWords.of(text, WORDS);
    }
}
