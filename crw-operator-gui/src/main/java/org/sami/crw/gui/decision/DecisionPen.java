package org.sami.crw.gui.decision;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.gui.decision.DecisionMap.PenEnd;
import org.sami.session.api.Judgement;
import org.sami.ui.geo.GeoSketch;

/**
 * The pen with which the shown decision is answered on the large map: ready as soon as the decision is in front and nothing else is being done there, put down by
 * Escape until it is taken up again. Where the map is not shown, a place is drawn in the small map of its field. On the event thread.
 */
final class DecisionPen {
    private static final String PUT_DOWN = "The pen is put down; Alt+D takes it up again";
    private static final String DRAW = "Enter or a double click ends, Escape puts the pen down";
    private static final String PICK =
            "Click boats, or draw a box with Shift held, to choose them for the answer; Escape puts the pen down";

    private final DecisionMap map;
    private final Consumer<PenEnd> ended;
    private final Set<Long> down = new HashSet<>();
    private Optional<DecisionView> held = Optional.empty();
    private Optional<GeoSketch> drawn = Optional.empty();

    /**
     * A pen that nobody has.
     *
     * @param ended is called when it was put down on the map
     */
    DecisionPen(DecisionMap map, Consumer<PenEnd> ended) {
        this.map = map;
        this.ended = ended;
    }

    /**
     * Keeps it as it should be; to be called whenever something changes, and a few times a second.
     *
     * @param shown the decision in front
     * @param answerable whether it can be answered
     */
    void tend(Optional<DecisionView> shown, boolean answerable) {
        boolean seen = map.isSeen();
        shown.ifPresent(view -> view.editor().useOwnMaps(!seen));
        Optional<DecisionView> wanting = shown.filter(view -> answerable && seen && isFor(view));
        if (held.isPresent() && !held.equals(wanting)) {
            lay();
        }
        held.flatMap(view -> view.editor().focusedSketch())
                .filter(sketch -> !drawn.equals(Optional.of(sketch)))
                .ifPresent(other -> lay()); // of several places the one is drawn in whose field the operator is
        if (held.isEmpty()) {
            wanting.filter(view -> !isDown(view) && map.isFree()).ifPresent(this::take);
        }
        map.say(wanting.map(this::words)
                .or(() -> shown.filter(view -> answerable && seen).flatMap(DecisionPen::lookedAt))
                .orElse(""));
    }

    /** Which of several options the map shows. */
    private static Optional<String> lookedAt(DecisionView view) {
        OptionalInt looked = view.editor().looked();
        return looked.isEmpty()
                ? Optional.empty()
                : Optional.of("Option " + (looked.getAsInt() + 1) + " of "
                        + view.editor().options() + " · Alt+Page Down shows the next one");
    }

    /** Whether a decision is answered on the map. */
    static boolean isFor(DecisionView view) {
        return view.pick().isPresent() || view.editor().sketch().isPresent();
    }

    private boolean isDown(DecisionView view) {
        return down.contains(view.decision().id());
    }

    /** Why it cannot be taken up for a decision; empty where it can. */
    Optional<String> whyNot(DecisionView view) {
        if (!isFor(view)) {
            return Optional.of("this decision asks for no place and no boats");
        }
        return map.isSeen()
                ? Optional.empty()
                : Optional.of("the map is not shown: bring it to the front, or draw here");
    }

    /** Whether it is out for a decision. */
    boolean isOut(DecisionView view) {
        return held.filter(view::equals).isPresent();
    }

    /** Takes it up on the operator's request. */
    void takeUp(DecisionView view) {
        down.remove(view.decision().id());
        lay();
        take(view);
        map.focus();
    }

    /** Puts it down until it is taken up again. Gives whether it was out. */
    boolean putDown() {
        boolean out = held.isPresent();
        held.ifPresent(view -> down.add(view.decision().id()));
        lay();
        return out;
    }

    /** Only these decisions wait. */
    void retain(Collection<Long> waiting) {
        down.retainAll(waiting);
    }

    private void take(DecisionView view) {
        held = Optional.of(view);
        drawn = view.editor().focusedSketch().or(() -> view.editor().sketch());
        drawn.ifPresentOrElse(
                sketch -> map.draw(sketch, end -> ended(view, end)),
                () -> map.pick(view.pick().orElseThrow(), end -> ended(view, end)));
        map.say(words(view));
    }

    private void ended(DecisionView view, PenEnd end) {
        held = Optional.empty();
        if (end != PenEnd.INTERRUPTED) {
            down.add(view.decision().id());
        }
        map.say(words(view));
        ended.accept(end);
    }

    /** Takes it from its present user; it is out again as soon as that is possible. */
    void lay() {
        held = Optional.empty();
        map.putDown();
    }

    /** What the map says: what the pen does, or what is to be minded of what is drawn; the panel says all of it. */
    private String words(DecisionView view) {
        if (!isOut(view)) {
            return isDown(view) ? PUT_DOWN : "";
        }
        Judgement judged = view.judged().judgement();
        List<String> said = new ArrayList<>(judged.refusal().map(List::of).orElseGet(judged::doubts));
        if (view.pick().isPresent()) {
            said.add(PICK);
        } else if (judged.refusal().isEmpty() && !judged.costs().isEmpty()) {
            said.add(judged.costs().get(judged.costs().size() - 1));
        } else if (said.isEmpty()) {
            said.add(DRAW);
        }
        return String.join(" · ", said);
    }
}
