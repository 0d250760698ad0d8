package org.sami.crw.gui.sound;

import java.util.Optional;
import org.sami.spn.protocol.Priority;

/**
 * How an alarm sounds, by its severity: distinguished by rhythm as well as by pitch, so that they are known in wind and by ears that hear no high
 * tones. Made by computing, from no file.
 */
public enum AlarmTone {
    /** Three quick high pairs. */
    CRITICAL(new int[][] {{988, 110}, {740, 110}, {988, 110}, {740, 110}, {988, 110}, {740, 110}}),
    /** Two notes upwards. */
    HIGH(new int[][] {{523, 160}, {0, 60}, {659, 220}}),
    /** One soft low note. */
    MEDIUM(new int[][] {{392, 240}});

    /** Samples a second of what {@link #samples} gives: one channel, 16 bits, the low byte first. */
    public static final int RATE_HZ = 22_050;

    private static final double LOUDNESS = 0.5;
    private static final double EDGE_S = 0.008; // rises and falls, or it clicks

    private final int[][] notes; // Hz (0 = none) and ms

    AlarmTone(int[][] notes) {
        this.notes = notes;
    }

    /** The tone of a severity; empty for one that makes no sound. */
    public static Optional<AlarmTone> of(Priority severity) {
        return switch (severity) {
            case CRITICAL -> Optional.of(CRITICAL);
            case HIGH -> Optional.of(HIGH);
            case MEDIUM -> Optional.of(MEDIUM);
            default -> Optional.empty();
        };
    }

    /** How long it sounds, in ms. */
    public long lengthMillis() {
        long all = 0;
        for (int[] note : notes) {
            all += note[1];
        }
        return all;
    }

    /** The sound itself. */
    public byte[] samples() {
        int count = (int) (lengthMillis() * RATE_HZ / 1000);
        byte[] bytes = new byte[2 * count];
        int at = 0;
        for (int[] note : notes) {
            int length = note[1] * RATE_HZ / 1000;
            for (int i = 0; i < length && at < count; i++, at++) {
                double seconds = (double) i / RATE_HZ;
                double edge = Math.min(1, Math.min(seconds, (double) (length - i) / RATE_HZ) / EDGE_S);
                double wave = Math.sin(2 * Math.PI * note[0] * seconds);
                short sample = (short) Math.round(wave * edge * LOUDNESS * Short.MAX_VALUE);
                bytes[2 * at] = (byte) sample;
                bytes[2 * at + 1] = (byte) (sample >> 8);
            }
        }
        return bytes;
    }
}
