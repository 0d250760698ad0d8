package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatReading;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.ReadingResult;
import org.sami.spn.host.HostClock;

/**
 * Notes down what the base is told of the boats' sensors: the first {@link #MOST} readings, which fit into memory. Readings are
 * no input of the engine. For the thread that drives the proxies.
 */
public final class ReadingRecorder implements BoatListener {
    /** So many readings are kept. */
    public static final int MOST = 500_000;

    private final HostClock clock;
    private final int most;
    private final List<ReadingResult> readings = new ArrayList<>();
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
                reading.position().latDeg(),
                reading.position().lonDeg());
    }

    /** Notes a reading. */
    public void add(ReadingResult reading) {
        if (readings.size() >= most) {
            dropped++;
        } else {
            readings.add(reading);
        }
    }

    /** What was noted, in order; unmodifiable. */
    public List<ReadingResult> readings() {
        return Collections.unmodifiableList(readings);
    }

    /** Says at a time that some are missing, if some are. */
    public List<NoteResult> notes(long atMillis) {
        return dropped == 0
                ? List.of()
                : List.of(new NoteResult(
                        atMillis, "readings", 0, dropped + " readings came after the first " + most + ": not kept"));
    }
}
