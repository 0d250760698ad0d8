package org.sami.crw.gui.decision;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.GraphicsEnvironment;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.gui.value.JudgementView;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.palette.SemanticColor;
import org.sami.session.api.Judgement;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Interactions;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Ids;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.look.Look;
import org.sami.ui.look.WidthTrackingPanel;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.value.WrappedText;

/**
 * What waits for the operator: the most urgent decision in full, with the components that are chosen for it, and the others as a list. Digits
 * choose options, Enter gives the answer that is filled in, Escape leaves. The reason why an answer would be refused is next to the button
 * before it is given. On the event thread.
 */
public final class DecisionsPanel extends JPanel implements DecisionSteps {
    /** What is said of a press that came before its question could be read. */
    static final String UNREAD = "Nothing was answered: this question has just come. Press again";

    private static final String NONE = "none";
    private static final String ONE = "one";
    private static final int LOW = 230;
    private static final int LOW_WITH_QUEUE = 300;
    private static final int GAP = 8;
    private static final int LEAST_ASKED = 80; // of what is filled in, with gaps and insets
    private static final double MOST_WAITING = 0.5; // of the panel's height

    private final CommandRegistry registry;
    private final DecisionActions actions;
    private final DecisionMap map;
    private final Interactions interactions;
    private final ComponentChoice choice;
    private final ValueEditors editors;
    private final ShownDecision shown;
    private final Map<Long, DecisionView> views = new HashMap<>();
    private final CardLayout cards = new CardLayout();
    private final JPanel deck = new JPanel(cards);
    private final JPanel body = new JPanel(new BorderLayout());
    private final DecisionPictures strip;
    private final DecisionHeader header;
    private final AnswerBar bar;
    private final AttentionFrame frame = new AttentionFrame(this);
    private final WaitingList waiting;
    private final DecisionCommands commands;
    private final DecisionPen pen;
    private final JudgementView judgement = new JudgementView("decision");
    private final PressTimes presses;
    private final Timer settle = new Timer((int) ShownDecision.REST_MILLIS + 10, event -> settle());
    private Optional<DecisionView> current = Optional.empty();
    private final AnswerGiving giving;
    private boolean unread; // the last press came before the question could be read
    private boolean chosen; // the operator turns to another question

    /**
     * Shows what waits.
     *
     * @param wallMillis the clock by which the display gives presses their times
     */
    DecisionsPanel(
            CommandRegistry registry,
            DecisionActions actions,
            Interactions interactions,
            ComponentChoice choice,
            ValueEditors editors,
            DecisionMap map,
            ShownPictures pictures,
            UnaryOperator<String> words,
            LongSupplier wallMillis) {
        super(new BorderLayout());
        this.registry = registry;
        this.actions = actions;
        this.map = map;
        this.interactions = interactions;
        this.choice = choice;
        this.editors = editors;
        presses = new PressTimes(wallMillis);
        strip = new DecisionPictures(registry, pictures);
        shown = new ShownDecision(() -> System.nanoTime() / 1_000_000);
        giving = new AnswerGiving(actions, this::given, this::refresh);
        pen = new DecisionPen(map, this::penEnded);
        commands = new DecisionCommands(registry, this);
        bar = new AnswerBar(commands);
        header = new DecisionHeader(new CommandButton(commands.stopTimer()));
        waiting = new WaitingList(this::select);
        settle.setRepeats(false);
        setName("decisions");
        deck.add(empty(words), NONE);
        deck.add(one(), ONE);
        add(deck);
        DecisionKeys.bind(this, this);
        PointerWatch.on(this, shown::pointerDown, () -> {
            shown.pointerUp();
            settle.restart();
        });
        refresh();
    }

    private static JComponent empty(UnaryOperator<String> words) {
        JPanel empty = new JPanel(new MigLayout("insets 16, fill", "[grow,fill]", "[center]"));
        empty.setOpaque(false);
        WrappedText text = new WrappedText(words.apply(
                "Nothing waits for you. When a mission asks for boats, an area, a choice between allocations or a "
                        + "yes, the most urgent question appears here, and the others in a list below it."));
        text.setName("decisions-empty");
        text.setColor(SemanticColor.MUTED);
        empty.add(text, "wmin 60");
        return empty;
    }

    private JComponent one() {
        JPanel column = new JPanel(new MigLayout(
                "novisualpadding, insets 8 12 8 12, gap 8 8, fill, hidemode 3, wrap 1",
                "[grow,fill]",
                "[][grow,fill][]"));
        column.setOpaque(false);
        JScrollPane scroll = new JScrollPane(new WidthTrackingPanel(scrolled()));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setName("decision-scroll");
        scroll.getVerticalScrollBar().setUnitIncrement(Look.px(16));
        column.add(header);
        column.add(scroll, "hmin 0");
        column.add(judgement, "wmin 0");
        column.add(bar, "wmin 0");
        column.add(waiting, "dock south, wmin 0");
        return column;
    }

    /** What may go out of sight in a low panel, so that title, timer and buttons never do. */
    private JComponent scrolled() {
        JPanel scrolled = new JPanel(new MigLayout(
                "novisualpadding, insets 0, gap 8 8, fillx, hidemode 3, wrap 1", "[grow,fill]", "[][grow,fill][]"));
        scrolled.setOpaque(false);
        body.setOpaque(false);
        scrolled.add(header.description(), "wmin 60");
        scrolled.add(body, "wmin 0");
        scrolled.add(strip.component(), "wmin 0"); // below what answers, which stays in sight
        return scrolled;
    }

    /** Where the panel is too low for the question, the asking mission is in a tooltip, and the reason why there is no answer yet in one line. */
    @Override
    public void doLayout() {
        boolean low = getHeight() < Look.px(waiting.isVisible() ? LOW_WITH_QUEUE : LOW);
        header.setLow(low);
        judgement.setLow(low);
        bar.fit(getWidth(), low);
        int judged = judgement.isVisible() ? judgement.getPreferredSize().height + Look.px(GAP) : 0;
        int asked = header.getPreferredSize().height + judged + bar.getPreferredSize().height + Look.px(LEAST_ASKED);
        waiting.fit(Math.min((int) (MOST_WAITING * getHeight()), getHeight() - asked), low);
        super.doLayout();
    }

    /** What waits has changed. */
    void queue(List<PendingDecision> pending) {
        shown.queue(pending);
        Set<Long> waiting = pending.stream().map(one -> one.decision().id()).collect(Collectors.toSet());
        views.keySet().retainAll(waiting);
        pen.retain(waiting);
        refresh();
    }

    /** An answer was taken: where its decision is shown yet the next one comes, else the operator is at another one by now. */
    private void given(DecisionView answered) {
        if (current.filter(answered::equals).isPresent()) {
            shown.follow();
        }
    }

    private void settle() {
        shown.settle();
        refresh();
    }

    /** Shows what is true now; called a few times a second, as ages and timers run. */
    public void refresh() {
        shown.settle();
        Optional<PendingDecision> pending = shown.shown();
        boolean other = !pending.map(one -> one.decision().id())
                .equals(current.map(view -> view.decision().id()));
        if (other) {
            turnTo(pending);
        }
        pending.ifPresent(one -> {
            header.show(one, actions.nowMillis());
            frame.show(one.attention());
        });
        strip.show(pending);
        current.ifPresent(view -> view.editor().showNow(editors.robots()));
        showQueue(other);
        current.ifPresent(view -> view.judged().look());
        settleAnswer();
        tendPen();
        tellProblem();
        bar.showPosition(shown.waiting() < 2 || shown.isOver() ? " " : shown.position() + 1 + " of " + shown.waiting());
        commands.refuse()
                .retitle(
                        current.filter(view -> view.decision().decision().isInterruptChoice())
                                        .isPresent()
                                ? "Withdraw the interrupt"
                                : "None of these");
        commands.refresh();
        offer();
    }

    private void tendPen() {
        pen.tend(
                current,
                !shown.isOver()
                        && giving.whyNot().isEmpty()
                        && actions.whyNotAct().isEmpty());
    }

    /** Of the pen that is out nobody needs to be offered it. */
    private void offer() {
        bar.offer(
                whyNotRefuse().isEmpty(),
                current.filter(view -> !pen.isOut(view) && pen.whyNot(view).isEmpty())
                        .isPresent());
    }

    /**
     * Lines of the queue stay under a pointer that is down. The queue becomes higher or lower, which moves what is above it, only as another
     * decision is shown, or while the pointer is elsewhere.
     */
    private void showQueue(boolean other) {
        if (!shown.rests()) {
            long inFull = shown.shown().map(one -> one.decision().id()).orElse(Ids.NONE);
            waiting.show(shown.queue(), inFull, actions.nowMillis());
        }
        if (other || GraphicsEnvironment.isHeadless() || getMousePosition(true) == null) {
            waiting.showRows(shown.waiting());
        }
    }

    private void turnTo(Optional<PendingDecision> pending) {
        boolean focused = DecisionKeys.hasFocusIn(this);
        giving.forget();
        presses.turned(!chosen);
        unread = false;
        pen.lay();
        body.removeAll();
        current = pending.map(one -> views.computeIfAbsent(one.decision().id(), id -> view(one)));
        current.ifPresent(view -> body.add(view.component()));
        cards.show(deck, current.isPresent() ? ONE : NONE);
        body.revalidate();
        body.repaint();
        current.ifPresentOrElse(view -> map.show(view.decision(), view.editor().values()), map::clear);
        if (focused) {
            focusDecision(); // else the focus goes on to what comes next in the window: the fleet stop
        }
    }

    private DecisionView view(PendingDecision pending) {
        DecisionView made =
                new DecisionView(pending.presentation(), interactions, choice, editors, actions, this::rejudged);
        made.editor().addListener(() -> edited(made));
        made.editor().onPressed(this::answer);
        made.editor().onLooked(() -> looked(made));
        return made;
    }

    /** Another option is looked at: it is drawn on the map in place of the one before. */
    private void looked(DecisionView view) {
        if (current.filter(view::equals).isPresent()) {
            map.show(view.decision(), view.editor().values());
            tendPen();
        }
    }

    private void edited(DecisionView view) {
        if (current.filter(view::equals).isPresent()) {
            if (view.editor().isTouched()) {
                shown.keep();
                attend();
            }
            giving.forget();
            unread = false;
            view.refused("");
            view.judged().look();
            map.show(view.decision(), view.editor().values());
            tellProblem();
            commands.refresh();
        }
    }

    /** The judgement of the entries has changed; an answer that waited for it is given, unless there is a warning first. */
    private void rejudged(DecisionView view) {
        if (current.filter(view::equals).isEmpty()) {
            return;
        }
        settleAnswer();
        tendPen();
        tellProblem();
    }

    private void settleAnswer() {
        current.ifPresent(view -> giving.settle(view, whyNot().isEmpty()));
        commands.refresh();
    }

    private void tellProblem() {
        Judgement judged = current.filter(view -> !shown.isOver())
                .map(view -> view.judged().judgement())
                .orElse(Judgement.NOTHING);
        judgement.show(judged);
        String refused = current.map(DecisionView::refusal).orElse("");
        String refusal = shown.isOver() ? "This decision was answered meanwhile" : refused;
        String text = refusal.isEmpty() ? whyNot().orElseGet(() -> unread ? UNREAD : giving.first(judged)) : refusal;
        bar.tell(
                text,
                !refused.isEmpty() || judged.refusal().filter(text::equals).isPresent());
    }

    private void attend() {
        shown.shown()
                .filter(pending -> pending.attention().isPresent())
                .ifPresent(pending -> actions.attend(pending.decision().id()));
    }

    // ---- what keys and buttons do

    @Override
    public Optional<String> whyNot() {
        if (current.isEmpty()) {
            return Optional.of("no decision waits");
        }
        if (shown.isOver()) {
            return Optional.of("this decision was answered meanwhile");
        }
        return giving.whyNot()
                .or(() -> registry.whyLocked("decision-answer")) // Enter, and yes and no, are no command
                .or(() -> current.get().whyNot(actions));
    }

    @Override
    public Optional<String> whyNotBrowse() {
        return shown.waiting() > 1 ? Optional.empty() : Optional.of("no other decision waits");
    }

    @Override
    public Optional<String> whyNotRefuse() {
        return current.filter(DecisionView::refusable).isPresent()
                        && !shown.isOver()
                        && giving.whyNot().isEmpty()
                ? Optional.empty()
                : Optional.of("this decision asks for a choice");
    }

    @Override
    public Optional<String> whyNotDraw() {
        return current.filter(view -> !shown.isOver()).map(pen::whyNot).orElse(Optional.of("no decision waits"));
    }

    @Override
    public void drawOnMap() {
        current.ifPresent(view -> {
            shown.keep();
            attend();
            pen.takeUp(view);
            offer();
        });
    }

    /** The pen was put down on the large map: who is done there comes back to the answer. */
    private void penEnded(DecisionMap.PenEnd end) {
        current.ifPresent(this::edited);
        offer();
        if (end == DecisionMap.PenEnd.DONE) {
            bar.focus();
        }
    }

    @Override
    public void escape() {
        if (pen.putDown()) {
            current.ifPresent(this::edited);
            refresh();
        } else {
            leave();
        }
    }

    @Override
    public Optional<String> whyNotStopTimer() {
        return shown.shown()
                        .filter(one -> one.presentation().autonomy().counts())
                        .isPresent()
                ? Optional.empty()
                : Optional.of("no timer runs");
    }

    @Override
    public void answer() {
        unread = presses.isHandledUnread();
        if (whyNot().isEmpty() && !unread) {
            attend();
            giving.press(current.orElseThrow());
            commands.refresh();
        }
        tellProblem();
    }

    @Override
    public void refuse() {
        unread = presses.isHandledUnread();
        if (!unread) {
            attend();
            giving.give(current.orElseThrow(), new Answer.Rejected());
            commands.refresh();
        }
        tellProblem();
    }

    @Override
    public void stopTimer() {
        current.ifPresent(giving::stopTimer);
    }

    @Override
    public void browse(int step) {
        shown.browse(step);
        turnToChosen();
    }

    @Override
    public Optional<String> whyNotLook() {
        return current.filter(view -> view.editor().looked().isPresent()).isPresent()
                ? Optional.empty()
                : Optional.of("the decision that is shown compares no options");
    }

    @Override
    public void look(int step) {
        current.ifPresent(view -> {
            shown.keep();
            view.editor().look(step);
        });
    }

    private void select(long decision) {
        shown.select(decision);
        turnToChosen();
    }

    private void turnToChosen() {
        chosen = true;
        try {
            refresh();
        } finally {
            chosen = false;
        }
    }

    @Override
    public void choose(int option) {
        current.filter(view -> !shown.isOver() && !presses.isHandledLate())
                .ifPresent(view -> view.editor().choose(option));
    }

    /** Leaves the shown decision: what was filled in is kept, and the most urgent one is shown again. */
    void leave() {
        shown.follow();
        refresh();
    }

    /** What the most urgent decision asks, where one waits and this panel lies behind another. */
    public Optional<String> waitingUnseen() {
        return isShowing()
                ? Optional.empty()
                : shown.mostUrgent().map(one -> DecisionWords.heading(one.presentation()));
    }

    @Override
    public void focusDecision() {
        current.ifPresentOrElse(view -> view.editor().focusTarget().requestFocusInWindow(), this::requestFocusInWindow);
    }
}
