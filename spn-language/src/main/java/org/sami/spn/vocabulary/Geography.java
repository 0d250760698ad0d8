package org.sami.spn.vocabulary;

/**
 * How far the robots of a domain get, so that checks can doubt what lies beyond.
 *
 * @param farM locations of one plan that lie farther apart than this, in metres, are probably a mistake
 * @param rangeM how far a robot gets on one charge, in metres
 */
public record Geography(double farM, double rangeM) {
    public Geography {
        if (!(farM > 0 && rangeM > 0)) {
            throw new IllegalArgumentException("Distances are more than 0 m, not " + farM + " and " + rangeM);
        }
    }
}
