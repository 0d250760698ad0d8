package org.sami.mavlink.onboard;

/**
 * A parameter that a vehicle has.
 *
 * @param name at most 16 characters
 */
public record OnboardParameter(String name, double value) {
    private static final int LONGEST = 16;

    /** A parameter.
     *
     * @throws IllegalArgumentException if the name is empty or does not fit a message
     */
    public OnboardParameter {
        if (name.isEmpty() || name.length() > LONGEST) {
            throw new IllegalArgumentException(
                    "the name of a parameter has 1 to " + LONGEST + " characters: \"" + name + "\"");
        }
    }
}
