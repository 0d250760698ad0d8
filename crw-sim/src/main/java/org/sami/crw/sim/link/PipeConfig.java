package org.sami.crw.sim.link;

/**
 * What a simulated link does to frames.
 *
 * @param latencyMs virtual time from sending to arriving
 * @param jitterMs most that a frame takes longer, drawn evenly for each; frames never overtake one another
 * @param lossProbability part of the frames that never arrive, 0 to 1
 */
public record PipeConfig(long latencyMs, long jitterMs, double lossProbability) {

    /** A good link: 20 ms, nothing lost. */
    public static final PipeConfig DEFAULT = new PipeConfig(20, 0, 0);

    /** Refuses what no link can do. */
    public PipeConfig {
        if (latencyMs < 0 || jitterMs < 0 || !(lossProbability >= 0 && lossProbability <= 1)) {
            throw new IllegalArgumentException("a link of " + latencyMs + " + " + jitterMs + " ms that loses "
                    + lossProbability + " of its frames");
        }
    }
}
