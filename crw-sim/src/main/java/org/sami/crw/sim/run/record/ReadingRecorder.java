package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.RowFormats;
import org.sami.crw.report.SpooledList;
import org.sami.crw.session.archive.SensorValue;

/**
 * Records the readings of the boats' sensors that the base receives: the first {@link #MOST}, in a file. Readings are
 * no input of the engine. Safe for use by several threads.
 */
public final class ReadingRecorder implements ReportFold {
    /** So many readings are kept. */
    public static final int MOST = 5_000_000;

    private final int most;
    private final SpooledList<ReadingResult> readings = new SpooledList<>(RowFormats.READING);
    private long dropped;

    /** A recorder that has noted nothing. */
    public ReadingRecorder() {
        this(MOST);
    }

    public ReadingRecorder(int most) {
        this.most = most;
    }

    /** Notes a reading, also one of an earlier process. */
    @Override
    public synchronized void onReading(SensorValue reading) {
        if (readings.size() >= most) {
            dropped++;
        } else {
            readings.add(new ReadingResult(
                    reading.atMillis(),
                    reading.boat(),
                    reading.sensor(),
                    reading.channel(),
                    reading.values(),
                    reading.unit(),
                    reading.position().latDeg(),
                    reading.position().lonDeg()));
        }
    }

    @Override
    public synchronized void addTo(ReportDraft report) {
        report.readings(readings());
        report.note(notes(report.end().atMillis()));
    }

    /** What was noted so far, in order; unmodifiable. */
    public synchronized List<ReadingResult> readings() {
        return readings.soFar();
    }

    /** Says at a time that some are missing, if some are. */
    public synchronized List<NoteResult> notes(long atMillis) {
        return dropped == 0
                ? List.of()
                : List.of(new NoteResult(
                        atMillis, "readings", 0, dropped + " readings came after the first " + most + ": not kept"));
    }
}
