package org.sami.crw.sim.run;

import java.util.List;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatReading;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.ReadingResult;
import org.sami.crw.sim.report.RowFormats;
import org.sami.crw.sim.report.SpooledList;
import org.sami.spn.host.HostClock;

/**
 * Notes down what the base is told of the boats' sensors: the first {@link #MOST} readings, which lie in a file. Readings are
 * no input of the engine. For the thread that drives the proxies.
 */
public final class ReadingRecorder implements BoatListener {
    /** So many readings are kept. */
    public static final int MOST = 5_000_000;

    private static final double PER_DEGREE = 1e7;

    private final HostClock clock;
    private final int most;
    private final SpooledList<ReadingResult> readings = new SpooledList<>(RowFormats.READING);
    private long dropped;

    /** A recorder that notes the time by a clock. */
    public ReadingRecorder(HostClock clock) {
        this(clock, MOST);
    }

    ReadingRecorder(HostClock clock, int most) {
        this.clock = clock;
        this.most = most;
    }

    @Override
    public void onReading(String boatId, BoatReading reading) {
        add(result(boatId, reading));
    }

    /** A reading that has come just now, as it is noted; not yet noted. */
    public ReadingResult result(String boatId, BoatReading reading) {
        return new ReadingResult(
                clock.nowMillis(),
                boatId,
                reading.sensor(),
                reading.channel(),
                reading.values(),
                reading.unit(),
                rounded(reading.position().latDeg()),
                rounded(reading.position().lonDeg()));
    }

    /** To a centimetre: no boat knows better where it was, and hours of readings take much room. */
    private static double rounded(double deg) {
        return Math.rint(deg * PER_DEGREE) / PER_DEGREE;
    }

    /** Notes a reading. */
    public void add(ReadingResult reading) {
        if (readings.size() >= most) {
            dropped++;
        } else {
            readings.add(reading);
        }
    }

    /** What was noted so far, in order; unmodifiable. */
    public List<ReadingResult> readings() {
        return readings.soFar();
    }

    /** Says at a time that some are missing, if some are. */
    public List<NoteResult> notes(long atMillis) {
        return dropped == 0
                ? List.of()
                : List.of(new NoteResult(
                        atMillis, "readings", 0, dropped + " readings came after the first " + most + ": not kept"));
    }
}
