package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.FieldType;

/** What the engine itself asks of the operator, and what becomes of the answers (R-DEC). */
final class Questions {
    private final World world;
    private final Attention attention;

    Questions(World world, Attention attention) {
        this.world = world;
        this.attention = attention;
    }

    /** Asks (R-INT-3) whom a pressed interrupt is for. */
    void askWhom(Mission m, String interrupt, List<String> boats) {
        Decision decision = new Decision(
                world.nextDecision++,
                m.id,
                Ids.NONE,
                Decision.INTERRUPT + interrupt,
                interrupt,
                new Question.ChooseProxies(boats, 1, Integer.MAX_VALUE),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of());
        world.questions.add(new World.Question(decision, Optional.empty()));
        world.effects.add(new Effect.DecisionOpened(decision));
    }

    void open(Visit visit, Activation activation, DecisionType type) {
        Question question = question(visit, activation, type);
        Optional<Answer> automatic = automatic(type, question, activation.markups());
        String when = trigger(activation.markups());
        OptionalLong deadline = OptionalLong.empty();
        if (when.equals("TIMER")) {
            long timeout = activation.markups().stream()
                    .filter(markup -> markup.type().equals("MixedInitiativeTrigger"))
                    .findFirst()
                    .flatMap(markup -> markup.option("timeout"))
                    .map(v -> ((DurationValue) v).millis())
                    .orElse(0L);
            deadline = OptionalLong.of(world.now + timeout);
        }
        Decision decision = new Decision(
                world.nextDecision++,
                activation.mission(),
                activation.id(),
                activation.type(),
                "",
                question,
                automatic,
                deadline,
                Priority.MEDIUM,
                activation.markups());
        boolean ofStanding = question instanceof Question.ChooseProxies
                && activation.proxies().isEmpty()
                && !standing(visit).isEmpty();
        world.questions.add(new World.Question(decision, Optional.of(visit), ofStanding));
        world.effects.add(new Effect.DecisionOpened(decision));
        if (deadline.isPresent()) {
            world.clocks.add(new World.Clock(
                    deadline.getAsLong(), world.nextClock++, Optional.empty(), Optional.empty(), decision.id()));
        }
        if (when.equals("IMMEDIATELY")) {
            world.internal.add(() -> answerByAutonomy(decision.id()));
        }
    }

    private Question question(Visit visit, Activation activation, DecisionType type) {
        return switch (type.form()) {
            case APPROVE -> new Question.Approve();
            case CHOOSE_PROXIES -> {
                List<String> all = candidates(visit, activation);
                List<String> kept =
                        all.stream().filter(boat -> passes(activation, boat)).toList();
                boolean tooFew = kept.isEmpty() || kept.size() < type.min();
                yield new Question.ChooseProxies(tooFew ? all : kept, type.min(), type.max());
            }
            case CHOOSE_OPTION ->
                new Question.ChooseOption(activation
                        .value(type.optionsField())
                        .map(v -> ((ListValue) v).items())
                        .orElse(List.of()));
            case PROVIDE ->
                new Question.FillIn(world.eventType(type.accepted()).fields().stream()
                        .map(Questions::item)
                        .toList());
            case REDEFINE_VARIABLE, DEFINE_VARIABLES, CHOOSE_VARIABLE ->
                throw new IllegalStateException("Not in the random plans");
        };
    }

    /** The boats that entered; where none did, those that stand in the place; else all known ones. */
    private List<String> candidates(Visit visit, Activation activation) {
        if (!activation.proxies().isEmpty()) {
            return activation.proxies();
        }
        List<String> here = standing(visit);
        return here.isEmpty() ? List.copyOf(world.proxies) : here;
    }

    private static List<String> standing(Visit visit) {
        return visit.mission.tokensIn(visit.place).stream()
                .filter(c -> c.token instanceof Token.Proxy)
                .map(c -> ((Token.Proxy) c.token).proxy())
                .distinct()
                .toList();
    }

    /** Whom a filtered question would offer now without its filters (R-DEC-10); empty for any other question. */
    private List<String> unfiltered(World.Question q) {
        boolean filtered =
                q.decision().markups().stream().anyMatch(markup -> markup.type().equals("Filter"));
        if (!filtered || q.visit().isEmpty()) {
            return List.of();
        }
        Visit visit = q.visit().get();
        Activation activation = activationOf(q);
        if (!activation.proxies().isEmpty()) {
            return activation.proxies().stream()
                    .filter(boat -> isStillIn(visit, activation, boat))
                    .toList();
        }
        return q.ofStanding() ? standing(visit) : List.copyOf(world.proxies);
    }

    private boolean isStillIn(Visit visit, Activation activation, String boat) {
        return visit.mission.standsInVisit(new Token.Proxy(boat), visit)
                || activation.tokens().stream()
                        .anyMatch(token -> token instanceof Token.Task
                                && world.boatOf(token).equals(Optional.of(boat))
                                && visit.mission.standsInVisit(token, visit));
    }

    private static Activation activationOf(World.Question q) {
        return q.visit().orElseThrow().activations.stream()
                .filter(a -> a.id() == q.decision().activation())
                .findFirst()
                .orElseThrow();
    }

    /** Boats left places of a mission: filters that keep too few of those who are there are given up (R-DEC-10). */
    void offerAllWhereFilteredLeft(Mission m) {
        for (World.Question q : List.copyOf(world.questions)) {
            if (q.decision().mission() == m.id && q.decision().question() instanceof Question.ChooseProxies choice) {
                List<String> all = unfiltered(q);
                List<String> left =
                        choice.proxies().stream().filter(all::contains).toList();
                if (left.size() < choice.proxies().size()
                        && left.size() < Math.max(1, choice.min())
                        && all.size() > left.size()) {
                    askAgain(q, all);
                    world.note(NoteKind.GONE, m.id, "");
                }
            }
        }
    }

    /** R-DEC-10: every filter lets it through. */
    private boolean passes(Activation activation, String boat) {
        String called = world.memory.get("description/" + boat) instanceof TextValue text ? text.value() : "";
        String known = (boat + " " + called).toLowerCase(Locale.ROOT);
        return activation.markups().stream()
                .filter(markup -> markup.type().equals("Filter"))
                .allMatch(markup -> {
                    String wanted = ((TextValue) markup.option("source").orElseThrow())
                            .value()
                            .toLowerCase(Locale.ROOT);
                    boolean drop =
                            markup.option("action").equals(Optional.of(new EnumValue("FilterAction", "EXCLUDE")));
                    return known.contains(wanted) != drop;
                });
    }

    /** R-DEC-11. */
    private static boolean selectsNobody(List<MarkupSpec> markups) {
        return markups.stream()
                .anyMatch(markup -> markup.type().equals("DefaultSelection")
                        && markup.option("selection").equals(Optional.of(new EnumValue("SelectionDefault", "NONE"))));
    }

    private static Question.Item item(FieldType f) {
        return new Question.Item(f.name(), f.type(), f.unit(), f.defaultValue(), true, f.help());
    }

    private static Optional<Answer> automatic(DecisionType type, Question question, List<MarkupSpec> markups) {
        if (type.autonomy() == AutonomyAnswer.ALL && selectsNobody(markups)) {
            return Optional.empty();
        }
        return switch (type.autonomy()) {
            case NONE, DEFAULTS -> Optional.empty();
            case YES -> Optional.of(new Answer.YesNo(true));
            case NO -> Optional.of(new Answer.YesNo(false));
            case ALL -> // all of nobody is no answer (R-DEC-2)
                Optional.of(((Question.ChooseProxies) question).proxies())
                        .filter(boats -> !boats.isEmpty())
                        .map(Answer.Proxies::new);
            case FIRST ->
                ((Question.ChooseOption) question).options().isEmpty()
                        ? Optional.empty()
                        : Optional.of(new Answer.Option(0));
        };
    }

    void answerByAutonomy(long decision) {
        find(decision).ifPresent(q -> {
            Optional<Answer> automatic = q.decision().automatic();
            if (automatic.isPresent() && fits(q.decision().question(), automatic.get())) {
                answer(q, automatic.get(), Answerer.AUTONOMY);
            } else {
                world.note(
                        NoteKind.NO_AUTOMATIC_ANSWER,
                        q.decision().mission(),
                        q.decision().type());
            }
        });
    }

    /** Choices that offered boats which their missions have lost are asked without them (R-DEC-8). */
    void askWithout(Map<Mission, List<String>> lost) {
        for (World.Question q : List.copyOf(world.questions)) {
            Decision old = q.decision();
            List<String> boats = lost.entrySet().stream()
                    .filter(entry -> entry.getKey().id == old.mission())
                    .flatMap(entry -> entry.getValue().stream())
                    .toList();
            if (!(old.question() instanceof Question.ChooseProxies choice)) {
                continue;
            }
            List<String> others = new ArrayList<>(choice.proxies());
            if (!others.removeAll(boats)) {
                continue;
            }
            List<String> all = new ArrayList<>(unfiltered(q));
            all.removeAll(boats);
            if (others.size() < Math.max(1, choice.min()) && all.size() > others.size()) {
                askAgain(q, all);
                world.note(NoteKind.GONE, old.mission(), "");
            } else if (others.isEmpty() && old.activation() == Ids.NONE) {
                close(q, Optional.empty(), Optional.empty());
                world.note(NoteKind.INTERRUPT_REFUSED, old.mission(), "");
            } else {
                askAgain(q, others);
            }
        }
    }

    /** Closes a choice and asks it for other boats, with the deadline that it had (R-DEC-8, R-DEC-9). */
    private void askAgain(World.Question q, List<String> boats) {
        Decision old = q.decision();
        Question.ChooseProxies choice = (Question.ChooseProxies) old.question();
        boolean runs = world.clocks.stream().anyMatch(clock -> clock.timer().isEmpty() && clock.decision() == old.id());
        close(q, Optional.empty(), Optional.empty());
        Question question = new Question.ChooseProxies(boats, choice.min(), choice.max());
        Decision decision = new Decision(
                world.nextDecision++,
                old.mission(),
                old.activation(),
                old.type(),
                old.prompt(),
                question,
                old.activation() == Ids.NONE
                        ? Optional.empty()
                        : automatic(world.eventType(old.type()).decision().orElseThrow(), question, old.markups()),
                runs ? old.deadlineMillis() : OptionalLong.empty(),
                Priority.MEDIUM,
                old.markups());
        world.questions.add(new World.Question(decision, q.visit(), q.ofStanding()));
        world.effects.add(new Effect.DecisionOpened(decision));
        if (runs) {
            world.clocks.add(new World.Clock(
                    old.deadlineMillis().orElseThrow(),
                    world.nextClock++,
                    Optional.empty(),
                    Optional.empty(),
                    decision.id()));
        }
        if (boats.isEmpty()) {
            world.note(NoteKind.NAMES_NOBODY, old.mission(), "");
        } else if (decision.automatic().isPresent() && trigger(old.markups()).equals("IMMEDIATELY")) {
            world.internal.add(() -> answerByAutonomy(decision.id()));
        }
    }

    /** When autonomy answers (R-DEC-2). */
    private static String trigger(List<MarkupSpec> markups) {
        return markups.stream()
                .filter(markup -> markup.type().equals("MixedInitiativeTrigger"))
                .findFirst()
                .flatMap(t -> t.option("trigger"))
                .map(v -> ((EnumValue) v).constant())
                .orElse("NEVER");
    }

    Optional<World.Question> find(long decision) {
        return world.questions.stream()
                .filter(q -> q.decision().id() == decision)
                .findFirst();
    }

    static boolean fits(Question question, Answer answer) {
        if (question instanceof Question.Approve) {
            return answer instanceof Answer.YesNo;
        }
        if (question instanceof Question.ChooseProxies choose) {
            return answer instanceof Answer.Proxies chosen
                    && chosen.proxies().size() >= choose.min()
                    && chosen.proxies().size() <= choose.max()
                    && choose.proxies().containsAll(chosen.proxies())
                    && new LinkedHashSet<>(chosen.proxies()).size()
                            == chosen.proxies().size();
        }
        if (question instanceof Question.ChooseOption options) {
            return answer instanceof Answer.Rejected
                    || (answer instanceof Answer.Option option
                            && option.index() >= 0
                            && option.index() < options.options().size());
        }
        return answer instanceof Answer.Fields fields && fits(((Question.FillIn) question).items(), fields.values());
    }

    private static boolean fits(List<Question.Item> items, Map<String, Value> values) {
        List<String> asked = items.stream().map(Question.Item::key).toList();
        for (Question.Item item : items) {
            Optional<Value> given = Optional.ofNullable(values.get(item.key()));
            boolean right = given.isEmpty()
                    ? item.defaultValue().isPresent()
                    : TypeCheck.accepts(item.type(), given.get(), Map.of())
                            && (item.editable() || given.equals(item.defaultValue()));
            if (!right) {
                return false;
            }
        }
        return asked.containsAll(values.keySet());
    }

    /** Whether a choice of boats names none (R-DEC-5). */
    boolean namesNobody(World.Question q, Answer answer) {
        return answer instanceof Answer.Proxies chosen
                && chosen.proxies().isEmpty()
                && q.decision().activation() != Ids.NONE
                && world.eventType(q.decision().type()).decision().orElseThrow().names() == AnswerNames.CHOSEN;
    }

    /** Takes an answer, unless whom it names is gone and somebody is asked for: then the question stays open (R-OCC-12). */
    void answer(World.Question q, Answer answer, Answerer by) {
        AnswerNames names =
                world.eventType(q.decision().type()).decision().orElseThrow().names();
        boolean isChoice = names == AnswerNames.CHOSEN;
        if (attention.namesOnlyGone(occurrence(q, answer), q.standing(), isChoice)) {
            world.note(NoteKind.NAMES_NOBODY, q.decision().mission(), "");
        } else { // answered once (R-DEC-1)
            close(q, Optional.of(answer), Optional.of(by));
            attention.receive(occurrence(q, answer), q.standing());
        }
    }

    private Occurrence occurrence(World.Question q, Answer answer) {
        Activation activation = activationOf(q);
        DecisionType type = world.eventType(activation.type()).decision().orElseThrow();
        boolean rejected = answer instanceof Answer.Rejected || (answer instanceof Answer.YesNo yesNo && !yesNo.yes());
        Map<String, Value> values = new LinkedHashMap<>();
        if (answer instanceof Answer.Option option) {
            Value chosen =
                    ((Question.ChooseOption) q.decision().question()).options().get(option.index());
            type.answerFields().forEach((field, from) -> {
                if (from.equals(".")) {
                    values.put(field, chosen);
                } else {
                    ((RecordValue) chosen).field(from).ifPresent(v -> values.put(field, v));
                }
            });
        } else if (answer instanceof Answer.Fields fields && type.form() == DecisionForm.PROVIDE) {
            values.putAll(withDefaults((Question.FillIn) q.decision().question(), fields));
        }
        List<String> proxies = List.of();
        List<TaskId> tasks = List.of();
        if (type.names() == AnswerNames.CHOSEN && answer instanceof Answer.Proxies chosen) {
            proxies = chosen.proxies();
        } else if (type.names() == AnswerNames.ENTERING) {
            proxies = activation.proxies();
            tasks = activation.tasks();
        }
        return Occurrence.answer(rejected ? type.rejected() : type.accepted(), activation, proxies, tasks, values);
    }

    static Map<String, Value> withDefaults(Question.FillIn question, Answer.Fields answer) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : question.items()) {
            Value given = item.editable() ? answer.values().get(item.key()) : null;
            if (given != null) {
                values.put(item.key(), given);
            } else {
                item.defaultValue().ifPresent(v -> values.put(item.key(), v));
            }
        }
        return values;
    }

    void close(World.Question q, Optional<Answer> answer, Optional<Answerer> by) {
        world.questions.remove(q);
        world.clocks.removeIf(
                c -> c.timer().isEmpty() && c.decision() == q.decision().id());
        world.effects.add(new Effect.DecisionClosed(q.decision().id(), answer, by));
    }

    void closeQuestions(Visit visit) {
        for (World.Question q : List.copyOf(world.questions)) {
            if (q.visit().equals(Optional.of(visit))) {
                close(q, Optional.empty(), Optional.empty());
            }
        }
    }
}
