package org.sami.crw.sim.link;

/**
 * What a simulated link does to frames.
 *
 * @param latencyMs virtual time from sending to arriving
 * @param jitterMs most that a frame takes longer, drawn evenly for each; frames never overtake one another
 * @param lossProbability part of the frames that never arrive, 0 to 1
 * @param isCoded whether the codec writes and reads every frame, as over TCP: costs time, and changes nothing else
 */
public record PipeConfig(long latencyMs, long jitterMs, double lossProbability, boolean isCoded) {

    /** A good link: 20 ms, nothing lost. */
    public static final PipeConfig DEFAULT = new PipeConfig(20, 0, 0);

    /** A link whose frames are passed as they are. */
    public PipeConfig(long latencyMs, long jitterMs, double lossProbability) {
        this(latencyMs, jitterMs, lossProbability, false);
    }

    /** Refuses what no link can do. */
    public PipeConfig {
        if (latencyMs < 0 || jitterMs < 0 || !(lossProbability >= 0 && lossProbability <= 1)) {
            throw new IllegalArgumentException("a link of " + latencyMs + " + " + jitterMs + " ms that loses "
                    + lossProbability + " of its frames");
        }
    }

    /** The same link, with every frame written and read by the codec. */
    public PipeConfig coded() {
        return new PipeConfig(latencyMs, jitterMs, lossProbability, true);
    }
}
