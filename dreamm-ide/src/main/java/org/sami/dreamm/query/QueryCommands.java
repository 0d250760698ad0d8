package org.sami.dreamm.query;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanWitness;
import org.sami.ui.command.Command;

/** What can be done with the queries of the open plan. On the event thread. */
public final class QueryCommands {
    private final DreammContext context;
    private final QueryAnswers answers;
    private final WitnessOnNet witness;
    private final Supplier<List<String>> robots;
    private final Supplier<Optional<StartMarking>> marked;
    private final BooleanSupplier hasErrors;
    private final List<Consumer<String>> asking = new CopyOnWriteArrayList<>();
    private Optional<String> selected = Optional.empty();

    /**
     * Adds the commands to a window's.
     *
     * @param robots names of the robots with which a plan is searched
     * @param marked where tokens were put for a start
     * @param hasErrors whether the project has errors: then it is not searched
     * @param player plays a run of the open plan
     */
    public QueryCommands(
            DreammContext context,
            QueryAnswers answers,
            WitnessOnNet witness,
            Supplier<List<String>> robots,
            Supplier<Optional<StartMarking>> marked,
            BooleanSupplier hasErrors,
            Consumer<TestCase> player) {
        this.context = Objects.requireNonNull(context, "context");
        this.answers = answers;
        this.witness = witness;
        this.robots = robots;
        this.marked = marked;
        this.hasErrors = hasErrors;
        add("query-all", "Answer all queries", "ctrl F12", "run-on", this::askAll, this::whyNotAsk);
        add(
                "query-one",
                "Answer the query",
                "F12",
                "play",
                this::askOne,
                () -> whyNotAsk().or(this::whyNone));
        add("query-happen", "Can this happen?", "shift F11", "help", this::askMarking, this::whyNotAskMarking);
        add(
                "query-stop",
                "Stop answering",
                "shift F12",
                "stop",
                answers::cancel,
                () -> answers.isRunning() ? Optional.empty() : Optional.of("no query is being answered"));
        add("query-show", "Show the run on the net, or no more", "alt F12", "net", this::show, this::whyNoRun);
        add("query-back", "One firing back", "ctrl shift F12", "left", () -> witness.step(-1), () -> whyNotStep(-1));
        add("query-next", "Next firing", "alt shift F12", "right", () -> witness.step(1), () -> whyNotStep(1));
        add(
                "query-play",
                "Take the run on the engine",
                "alt F11",
                "hand",
                () -> steps().ifPresent(run -> {
                    witness.end();
                    player.accept(run);
                }),
                this::whyNoSteps);
        add("query-remove", "Remove the query", "alt shift F11", "clear", this::remove, this::whyNone);
        answers.addListener(this::changed);
        witness.addListener(() -> context.commands().refresh());
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                witness.end();
            }

            @Override
            public void selectionChanged() {
                context.commands().refresh();
            }
        });
    }

    private void add(
            String id, String title, String key, String icon, Runnable run, Supplier<Optional<String>> whyNot) {
        context.commands()
                .add(new Command(id, title, run).withIcon(icon).unless(whyNot).withKey(key));
    }

    private void changed() {
        Optional<PlanWitness> shown = witness.shown();
        if (shown.isPresent() && !shown.equals(answer().flatMap(PlanQueryAnswer::witness))) {
            witness.end();
        }
        context.commands().refresh();
    }

    /** Chooses the query that commands are about, by its name. */
    void select(Optional<String> name) {
        if (!selected.equals(name)) {
            selected = name;
            witness.end();
            context.commands().refresh();
        }
    }

    private Optional<QueryRow> row() {
        return answers.rows().stream()
                .filter(row -> selected.equals(Optional.of(row.query().name())))
                .findFirst();
    }

    private Optional<PlanQueryAnswer> answer() {
        return row().flatMap(QueryRow::answer);
    }

    private Optional<TestCase> steps() {
        return answer().flatMap(PlanQueryAnswer::witness).flatMap(PlanWitness::steps);
    }

    private Optional<String> whyNone() {
        return row().isPresent() ? Optional.empty() : Optional.of("no query is selected");
    }

    private Optional<String> whyNotAsk() {
        if (answers.isRunning()) {
            return Optional.of("queries are being answered already");
        }
        if (answers.queries().isEmpty()) {
            return Optional.of("the open plan has no query");
        }
        return whyErrors();
    }

    private Optional<String> whyErrors() {
        return hasErrors.getAsBoolean()
                ? Optional.of("there are errors: mend those first, plans with errors are not searched")
                : Optional.empty();
    }

    private Optional<String> whyNoRun() {
        return answer().flatMap(PlanQueryAnswer::witness).isPresent()
                ? Optional.empty()
                : whyNone()
                        .or(() -> Optional.of(
                                answer().isPresent() ? "no run shows this answer" : "answer the query first (F12)"));
    }

    private Optional<String> whyNotStep(int steps) {
        return witness.canGo(steps)
                ? Optional.empty()
                : Optional.of(
                        witness.shown().isEmpty()
                                ? "show a run on the net first (Alt+F12)"
                                : steps > 0 ? "the run ends here" : "this is the start");
    }

    private Optional<String> whyNoSteps() {
        return steps().isPresent()
                ? Optional.empty()
                : whyNoRun().or(() -> Optional.of("the engine was not seen to do it: it is a run of the net"));
    }

    private void askAll() {
        answers.ask(answers.queries(), robots.get());
    }

    private void askOne() {
        row().ifPresent(row -> answers.ask(List.of(row.query()), robots.get()));
    }

    /** Keeps and answers the question whether tokens can stand as they are marked. */
    private void askMarking() {
        asked().ifPresent(query -> {
            keep(query);
            asking.forEach(listener -> listener.accept(query.name()));
            answers.ask(List.of(query), robots.get());
        });
    }

    private Optional<PlanQuery> asked() {
        return context.editor()
                .plan()
                .flatMap(plan ->
                        AskedMarking.of(plan, marked.get(), context.editor().selection()));
    }

    private Optional<String> whyNotAskMarking() {
        if (answers.isRunning()) {
            return Optional.of("queries are being answered already");
        }
        return whyErrors()
                .or(() -> asked().isPresent()
                        ? Optional.empty()
                        : Optional.of("select places on the net, or put tokens into them for a start (Try it)"));
    }

    /** Calls somebody with the name of a query that a command keeps and answers. */
    void addAskListener(Consumer<String> listener) {
        asking.add(listener);
    }

    private void show() {
        if (witness.shown().isPresent()) {
            witness.end();
        } else {
            answer().flatMap(PlanQueryAnswer::witness).ifPresent(witness::show);
        }
    }

    private void remove() {
        row().ifPresent(row -> context.editor()
                .planId()
                .ifPresent(plan ->
                        context.apply(new ProjectEdit.SetQuery(plan, row.query().name(), Optional.empty()))));
    }

    /** Keeps a query with the open plan; one of that name is replaced. */
    void keep(PlanQuery query) {
        context.editor()
                .planId()
                .ifPresent(plan -> context.apply(new ProjectEdit.SetQuery(plan, query.name(), Optional.of(query))));
    }
}
