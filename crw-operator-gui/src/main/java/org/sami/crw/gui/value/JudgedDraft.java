package org.sami.crw.gui.value;

import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Supplier;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;

/**
 * The judgement of an answer, or of other values, as they are filled in now: made off the event thread, one draft at a time, and again every few seconds, as boats move. On the
 * event thread.
 */
public final class JudgedDraft {
    private static final long RETRY_NANOS = 3_000_000_000L;

    private final Supplier<DraftAnswer> draft;
    private final Function<DraftAnswer, CompletionStage<Judgement>> judge;
    private final Runnable changed;
    private DraftAnswer asked = DraftAnswer.EMPTY;
    private DraftAnswer answered = DraftAnswer.EMPTY;
    private Judgement judgement = Judgement.NOTHING;
    private boolean underWay;
    private long askedNanos;

    /**
     * Nothing is judged yet.
     *
     * @param draft what is filled in now
     * @param judge judges; its results arrive on the event thread
     * @param changed is called when the judgement changes
     */
    public JudgedDraft(
            Supplier<DraftAnswer> draft, Function<DraftAnswer, CompletionStage<Judgement>> judge, Runnable changed) {
        this.draft = draft;
        this.judge = judge;
        this.changed = changed;
    }

    /** Has the present draft judged, unless it is so already. */
    public void look() {
        DraftAnswer now = draft.get();
        boolean old = !now.equals(DraftAnswer.EMPTY) && System.nanoTime() - askedNanos > RETRY_NANOS;
        if (underWay || (now.equals(asked) && !old)) {
            return;
        }
        underWay = true;
        asked = now;
        askedNanos = System.nanoTime();
        judge.apply(now).whenComplete((said, fault) -> {
            underWay = false;
            answered = now;
            judgement = fault == null
                    ? said
                    : Judgement.NOTHING; // a draft that cannot be judged is checked when it is given
            changed.run();
            if (!draft.get().equals(asked)) {
                look();
            }
        });
    }

    /** Whether the judgement is of the present entries. */
    public boolean isCurrent() {
        return draft.get().equals(answered);
    }

    /** The last judgement; later entries are not judged yet. */
    public Judgement judgement() {
        return judgement;
    }
}
