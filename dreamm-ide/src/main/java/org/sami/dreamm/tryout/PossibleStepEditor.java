package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Interactions;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.stepping.SampleValues;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.ui.value.ChoiceRow;
import org.sami.ui.value.Entry;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.NamedThings;
import org.sami.ui.value.OfferedRow;
import org.sami.ui.value.QuestionEditor;
import org.sami.ui.value.ValueContext;
import org.sami.ui.value.ValueEditor;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.value.ValueField;
import org.sami.ui.value.ValueSummary;
import org.sami.ui.value.WrappedText;

/** Gives what a possible step needs: an answer, who is named, values. Lives on the event thread; another step gets another editor. */
final class PossibleStepEditor {
    private static final long USUAL_WAIT_MS = 10_000;

    private final TryOut tryOut;
    private final PossibleStep possibleStep;
    private final Stepper stepper;
    private final ComponentChoice choice;
    private final ValueEditors editors;
    private final JPanel panel = new JPanel(new MigLayout("insets 4 12 4 12, gap 4 4, wrap, fillx", "[grow, fill]"));
    private final Map<String, JCheckBox> robots = new LinkedHashMap<>();
    private final Map<TaskId, JCheckBox> tasks = new LinkedHashMap<>();
    private final Map<String, ValueEditor> values = new LinkedHashMap<>();
    private Optional<QuestionEditor> question = Optional.empty();

    PossibleStepEditor(DreammContext context, TryOut tryOut, PossibleStep possibleStep, Stepper stepper) {
        this.tryOut = tryOut;
        this.possibleStep = possibleStep;
        this.stepper = stepper;
        choice = new ComponentChoice(context.components(), context.vocabulary().types());
        editors = new ValueEditors(
                choice, new ValueContext(context.vocabulary().types(), new Robots(stepper), MapMaker.PLAIN));
        panel.setName("possible-step-editor");
        panel.setOpaque(false);
        WrappedText title = WrappedText.strong(possibleStep.what());
        title.setName("possible-step-title");
        title.setToolTipText(possibleStep.what());
        panel.add(title, "wmin 0");
        fill(context);
    }

    private void fill(DreammContext context) {
        PossibleStep.What what = possibleStep.of();
        if (what instanceof PossibleStep.What.Decide decide) {
            ask(context, decide.decision());
        } else if (what instanceof PossibleStep.What.Respond respond) {
            name(respond.type(), respond.asked().proxies(), respond.asked().tasks(), true);
            give(respond.type());
        } else if (what instanceof PossibleStep.What.News news) {
            name(news.type(), stepper.view().proxies(), List.of(), false);
            give(news.type());
        } else if (what instanceof PossibleStep.What.Press press
                && press.button().asksForProxies()) {
            boxes("For which robots", stepper.view().proxies(), false);
        } else if (what instanceof PossibleStep.What.Wait wait) {
            long millis = wait.nextTimerMillis() < 0 ? USUAL_WAIT_MS : wait.nextTimerMillis();
            add(
                    new ValueField("wait", "How long", ValueType.Simple.DURATION, "", "The time that passes"),
                    Optional.of(new DurationValue(millis)));
        }
    }

    private void ask(DreammContext context, Decision decision) {
        ChosenComponent chosen = new Interactions(context.vocabulary())
                .of(decision)
                .map(choice::choose)
                .orElse(new ChosenComponent.Warning("This decision asks for nothing: answer it"));
        QuestionEditor editor =
                new QuestionEditor("try", decision.question(), offered(decision.question()), chosen, editors);
        question = Optional.of(editor);
        panel.add(editor.component(), "wmin 0, growx");
    }

    private static List<OfferedRow> offered(Question question) {
        if (question instanceof Question.ChooseProxies choose) {
            return IntStream.range(0, choose.proxies().size())
                    .mapToObj(i -> new OfferedRow(
                            i,
                            new ChoiceRow(
                                    new ProxyValue(choose.proxies().get(i)),
                                    choose.proxies().get(i),
                                    ""),
                            i < choose.max()))
                    .toList();
        }
        return question instanceof Question.ChooseOption choose
                ? IntStream.range(0, choose.options().size())
                        .mapToObj(i -> new OfferedRow(
                                i,
                                new ChoiceRow(
                                        choose.options().get(i),
                                        ValueSummary.of(choose.options().get(i)),
                                        ""),
                                i == 0))
                        .toList()
                : List.of();
    }

    private void name(EventType type, List<String> proxies, List<TaskId> about, boolean all) {
        if (type.tokens() == TokenNeed.PROXY || type.tokens() == TokenNeed.PROXY_OR_TASK) {
            boxes("It names", proxies, all);
        }
        if (!about.isEmpty() && (type.tokens() == TokenNeed.TASK || type.tokens() == TokenNeed.PROXY_OR_TASK)) {
            JPanel row = row("Tasks");
            for (TaskId task : about) {
                JCheckBox box = new JCheckBox(task.name(), all);
                box.setName("try-task-" + task.name());
                tasks.put(task, box);
                row.add(box);
            }
        }
    }

    private void boxes(String label, List<String> names, boolean all) {
        JPanel row = row(label);
        for (String name : names) {
            JCheckBox box = new JCheckBox(name, all || robots.isEmpty());
            box.setName("try-robot-" + name);
            robots.put(name, box);
            row.add(box);
        }
    }

    private JPanel row(String label) {
        panel.add(new JLabel(label));
        JPanel row = new JPanel(new MigLayout("insets 0, gap 8 0, wrap 4"));
        row.setOpaque(false);
        panel.add(row, "wmin 0");
        return row;
    }

    private void give(EventType type) {
        List<TaskId> known = tasks.isEmpty() ? List.of() : List.copyOf(tasks.keySet());
        SampleValues samples =
                new SampleValues(stepper.view().vocabulary(), stepper.view().proxies(), known, tryOut.locations());
        type.fields()
                .forEach(field -> add(ValueField.of(field), field.defaultValue().or(() -> samples.of(field.type()))));
    }

    private void add(ValueField field, Optional<Value> shown) {
        ValueEditor editor = editors.editor(field);
        shown.ifPresent(editor::show);
        values.put(field.path(), editor);
        JLabel label = new JLabel(field.label());
        label.setLabelFor(editor.focusTarget());
        label.setToolTipText(field.help().isEmpty() ? null : field.help());
        panel.add(label);
        panel.add(editor.component(), "wmin 0");
    }

    JComponent component() {
        return panel;
    }

    /** Whether the author has changed something here: then it must not be replaced. */
    boolean isTouched() {
        return question.filter(QuestionEditor::isTouched).isPresent()
                || values.values().stream().anyMatch(ValueEditor::isTouched);
    }

    PossibleStep possibleStep() {
        return possibleStep;
    }

    /** Whether "none of these" is an answer. */
    boolean canReject() {
        return possibleStep.of() instanceof PossibleStep.What.Decide decide
                && decide.decision().question() instanceof Question.ChooseOption;
    }

    /** Lets it happen; why it cannot, in one line, where something is missing. */
    Optional<String> happen() {
        PossibleStep.What what = possibleStep.of();
        if (what instanceof PossibleStep.What.Decide decide) {
            Optional<Answer> answer = question.orElseThrow().answer();
            if (answer.isEmpty()) {
                return question.get().reason().or(() -> Optional.of("nothing is chosen yet"));
            }
            return answer(decide.decision(), answer.get());
        } else if (what instanceof PossibleStep.What.Respond respond) {
            Activation asked = respond.asked();
            String words = respond.type().title() + whom() + ", answering "
                    + stepper.words().asking(asked.event(), respond.type().name());
            return tryOut.done(words, s -> s.occur(asked.id(), respond.type().name(), checked(), about(), given()))
                    .refusal();
        } else if (what instanceof PossibleStep.What.News news) {
            return tryOut.done(
                            news.type().title() + whom(),
                            s -> s.news(news.type().name(), checked(), about(), given()))
                    .refusal();
        } else if (what instanceof PossibleStep.What.Press press) {
            return tryOut.take(new TestStep.Press(press.button().name(), checked()))
                    .refusal();
        } else if (what instanceof PossibleStep.What.Wait) {
            Entry wait = Objects.requireNonNull(values.get("wait"), "wait").entry();
            return wait.value()
                    .map(DurationValue.class::cast)
                    .map(given ->
                            tryOut.take(new TestStep.Advance(given.millis())).refusal())
                    .orElseGet(wait::reason);
        }
        PossibleStep.What.Robot robot = (PossibleStep.What.Robot) what;
        return tryOut.take(robot.joins() ? new TestStep.Join(robot.name()) : new TestStep.Drop(robot.name()))
                .refusal();
    }

    /** The operator takes none of what is offered. */
    Optional<String> reject() {
        return answer(((PossibleStep.What.Decide) possibleStep.of()).decision(), new Answer.Rejected());
    }

    private Optional<String> answer(Decision decision, Answer answer) {
        return tryOut.done(
                        "operator: " + AnswerWords.of(answer, stepper.words()) + asked(decision),
                        s -> s.answer(decision.id(), answer))
                .refusal();
    }

    private String asked(Decision decision) {
        String asking = stepper.eventAsking(decision);
        return asking.isEmpty() ? "" : " to " + stepper.words().deciding(asking);
    }

    private String whom() {
        List<String> named = new ArrayList<>(checked());
        about().forEach(task -> named.add(task.name()));
        return named.isEmpty() ? "" : " of " + String.join(", ", named);
    }

    private List<String> checked() {
        return robots.entrySet().stream()
                .filter(box -> box.getValue().isSelected())
                .map(Map.Entry::getKey)
                .toList();
    }

    private List<TaskId> about() {
        return tasks.entrySet().stream()
                .filter(box -> box.getValue().isSelected())
                .map(Map.Entry::getKey)
                .toList();
    }

    private Map<String, Value> given() {
        Map<String, Value> given = new LinkedHashMap<>();
        values.forEach((name, editor) -> editor.entry().value().ifPresent(value -> given.put(name, value)));
        return given;
    }

    /** The robots of the run, as editors of values offer them. */
    private record Robots(Stepper stepper) implements NamedThings {
        @Override
        public List<ChoiceRow> proxies() {
            return stepper.view().proxies().stream()
                    .map(robot -> new ChoiceRow(new ProxyValue(robot), robot, ""))
                    .toList();
        }
    }
}
