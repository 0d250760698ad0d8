package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.report.NoteResult;
import org.sami.spn.protocol.Ids;

/**
 * Records alarms about the fence: a boat is, or is sent, outside. Other alarms are in the report by their own folds. Called on the models' thread,
 * read on any.
 */
public final class FenceNotes implements ReportFold {
    private static final int MOST = 100;

    private final List<NoteResult> notes = new CopyOnWriteArrayList<>();
    private long last;

    FenceNotes(OperatorModels models) {
        models.alarms().addListener(this::alarms);
    }

    private void alarms(List<Alarm> now) {
        for (Alarm alarm : raised(now, last)) {
            last = Math.max(last, alarm.number());
            if (notes.size() < MOST) {
                notes.add(new NoteResult(alarm.sinceMillis(), NoteResult.FENCE, Ids.NONE, alarm.text()));
            }
        }
    }

    /** Alarms about the fence with a higher number than that one, oldest first. */
    public static List<Alarm> raised(List<Alarm> now, long after) {
        return now.stream()
                .filter(alarm -> alarm.number() > after)
                .filter(alarm -> alarm.kind() == Alarm.Kind.FENCE || alarm.kind() == Alarm.Kind.FENCE_AHEAD)
                .sorted((one, other) -> Long.compare(one.number(), other.number()))
                .toList();
    }

    @Override
    public void addTo(ReportDraft report) {
        report.note(notes);
    }
}
