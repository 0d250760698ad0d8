package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongSupplier;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.report.NoteResult;

/** Records when a mission was stuck, why, and when it went on. Called on the models' thread, read on any. */
final class StuckNotes implements ReportFold {
    private static final int MOST = 100;

    private final LongSupplier nowMillis;
    private final List<NoteResult> notes = new CopyOnWriteArrayList<>();
    private final Map<Long, HealthEntry> open = new TreeMap<>(); // by number

    /** @param nowMillis the session's clock */
    StuckNotes(OperatorModels models, LongSupplier nowMillis) {
        this.nowMillis = nowMillis;
        models.health().addListener(this::health);
    }

    private void health(Health now) {
        Map<Long, HealthEntry> before = new TreeMap<>(open);
        for (HealthEntry entry : now.of(HealthKind.MISSION)) {
            before.remove(entry.number());
            if (open.put(entry.number(), entry) == null) {
                note(entry.sinceMillis(), entry, entry.fault().text());
            }
        }
        before.forEach((number, entry) -> {
            open.remove(number);
            note(nowMillis.getAsLong(), entry, entry.fault().subject() + " is not stuck any longer");
        });
    }

    private void note(long atMillis, HealthEntry entry, String text) {
        if (notes.size() < MOST) {
            notes.add(new NoteResult(atMillis, NoteResult.STUCK, entry.fault().mission(), text));
        }
    }

    @Override
    public void addTo(ReportDraft report) {
        report.note(notes);
    }
}
