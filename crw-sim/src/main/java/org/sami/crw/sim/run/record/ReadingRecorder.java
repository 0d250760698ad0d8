package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.boat.link.LookoutReadings;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.RowFormats;
import org.sami.crw.report.SpooledList;
import org.sami.session.record.SensorValue;

/**
 * Records sensor readings that the base receives: the first {@link #MOST}, in a file. Readings are not inputs of the engine. Safe for use by several
 * threads.
 */
public final class ReadingRecorder implements ReportFold {
    /** Number of readings that are kept. */
    public static final int MOST = 5_000_000;

    private final int most;
    private final SpooledList<ReadingResult> readings = new SpooledList<>(RowFormats.READING);
    private long dropped;

    /** A recorder without readings. */
    public ReadingRecorder() {
        this(MOST);
    }

    public ReadingRecorder(int most) {
        this.most = most;
    }

    /** Records a reading, also one of an earlier process; not what boats see of vessels, of which the report has a part of its own. */
    @Override
    public synchronized void onReading(SensorValue reading) {
        if (reading.sensor().equals(LookoutReadings.SENSOR)) {
            return;
        }
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

    /** All readings so far, in order; unmodifiable. */
    public synchronized List<ReadingResult> readings() {
        return readings.soFar();
    }

    /** A note at this time if readings are missing. */
    public synchronized List<NoteResult> notes(long atMillis) {
        return dropped == 0
                ? List.of()
                : List.of(new NoteResult(
                        atMillis, "readings", 0, dropped + " readings came after the first " + most + ": not kept"));
    }
}
