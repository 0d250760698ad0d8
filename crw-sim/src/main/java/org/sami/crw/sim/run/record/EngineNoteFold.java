package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sami.crw.report.NoteResult;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;

/** What the engine noted. */
final class EngineNoteFold implements ReportFold {
    private final List<NoteResult> notes = new ArrayList<>();

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Noted noted) {
                String kind = noted.kind() == NoteKind.DISCARDED && !isAnswer(input)
                        ? NoteResult.NEWS
                        : noted.kind().name().toLowerCase(Locale.ROOT);
                notes.add(new NoteResult(atMillis, kind, noted.mission(), noted.message()));
            }
        }
    }

    /** Whether somebody was asked for it. Of news, and of a press that is refused, nobody misses what no transition takes. */
    private static boolean isAnswer(Input input) {
        return !(input instanceof Input.Interrupt)
                && !(input instanceof Input.Received received
                        && received.occurrence().activation() == Ids.NONE);
    }

    @Override
    public void addTo(ReportDraft report) {
        report.note(notes);
    }
}
