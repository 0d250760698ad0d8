package org.sami.dreamm.suggestion;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.dreamm.compare.PlanComparison;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.wizard.Additions;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.suggestion.EdgeSuggestions;
import org.sami.spn.suggestion.Suggestion;
import org.sami.spn.suggestion.SuggestionRequest;
import org.sami.spn.suggestion.SuggestionResult;
import org.sami.spn.suggestion.SuggestionWatch;
import org.sami.ui.command.Command;

/**
 * Suggests requirements at the selected edge. The search runs in the background; its suggestions are gone through one by one, each shown on the
 * net with what it changes, until the author writes one on the edge or leaves. All ends when the plan or the selection becomes another.
 */
public final class SuggestionCommands {
    private static final String ID = "edge-suggest";

    private final DreammContext context;
    private final Executor worker;
    private final Executor owner;
    private final int statesPerSearch;
    private Optional<AtomicBoolean> running = Optional.empty();
    private boolean isShown;

    private SuggestionCommands(DreammContext context, Executor worker, Executor owner, int statesPerSearch) {
        this.context = Objects.requireNonNull(context, "context");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        this.statesPerSearch = statesPerSearch;
    }

    /**
     * Adds the command to a window's.
     *
     * @param worker runs the search
     * @param owner runs what belongs to the window's thread
     */
    public static void addTo(DreammContext context, Executor worker, Executor owner) {
        addTo(context, worker, owner, SuggestionRequest.STATES_PER_SEARCH);
    }

    static void addTo(DreammContext context, Executor worker, Executor owner, int statesPerSearch) {
        SuggestionCommands suggestions = new SuggestionCommands(context, worker, owner, statesPerSearch);
        context.commands()
                .add(new Command(ID, "Suggest requirements…", suggestions::search)
                        .withIcon("search")
                        .unless(suggestions::whyNot))
                .withKey("ctrl shift R");
        context.document().addListener(change -> suggestions.end());
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                suggestions.end();
            }

            @Override
            public void selectionChanged() {
                suggestions.end();
            }
        });
    }

    private Optional<String> whyNot() {
        Optional<Plan> plan = context.editor().plan();
        if (plan.isEmpty()) {
            return Optional.of("no plan is open");
        }
        if (running.isPresent()) {
            return Optional.of("a search for requirements runs already");
        }
        Set<String> selection = context.editor().selection();
        List<Boolean> locked = new ArrayList<>();
        plan.get().inEdges().stream()
                .filter(edge -> selection.contains(edge.id()))
                .map(InEdge::locked)
                .forEach(locked::add);
        plan.get().outEdges().stream()
                .filter(edge -> selection.contains(edge.id()))
                .map(OutEdge::locked)
                .forEach(locked::add);
        if (selection.size() != 1 || locked.size() != 1) {
            return Optional.of("select one edge: requirements are suggested for it");
        }
        return locked.get(0)
                ? Optional.of("the edge is locked")
                : context.profile().whyLocked(ID);
    }

    private void search() {
        end();
        SuggestionRequest request = new SuggestionRequest(
                context.document().project(),
                context.vocabulary(),
                context.editor().planId().orElseThrow(),
                context.editor().selection().iterator().next(),
                SuggestionRequest.TEAMS,
                statesPerSearch,
                SuggestionRequest.ALL_STATES);
        AtomicBoolean cancelled = new AtomicBoolean();
        running = Optional.of(cancelled);
        SuggestionWatch watch = new SuggestionWatch() {
            @Override
            public void tried(int candidates, int all) {
                owner.execute(() -> progress(cancelled, candidates, all));
            }

            @Override
            public boolean isCancelled() {
                return cancelled.get();
            }
        };
        ask(
                "Trying the requirements that this edge can have, with 1, 2 and 3 robots",
                List.of(choice("stop", "Stop", () -> {
                    isShown = false;
                    cancelled.set(true); // the suggestions found until then are shown
                })));
        worker.execute(() -> {
            try {
                SuggestionResult result = EdgeSuggestions.find(request, watch);
                owner.execute(() -> done(cancelled, result));
            } catch (IllegalArgumentException refused) {
                owner.execute(() -> failed(cancelled, String.valueOf(refused.getMessage())));
            }
        });
    }

    private void progress(AtomicBoolean search, int tried, int all) {
        if (isRunning(search)) {
            context.notices().show("Suggest requirements: " + tried + " of " + all + " sets tried");
        }
    }

    private void done(AtomicBoolean search, SuggestionResult result) {
        if (isRunning(search)) {
            end();
            context.notices().show(result.summary());
            if (!result.suggestions().isEmpty()) {
                show(result, 0);
            }
        }
    }

    private void failed(AtomicBoolean search, String why) {
        if (isRunning(search)) {
            end();
            context.notices().refused(why);
        }
    }

    /** Whether a search is still wanted: the plan and the selection are those with which it began. */
    private boolean isRunning(AtomicBoolean search) {
        return running.filter(current -> current == search).isPresent();
    }

    /** Shows one suggestion on the net, and asks whether to write it on the edge. */
    private void show(SuggestionResult result, int at) {
        Suggestion suggestion = result.suggestions().get(at);
        Plan plan = context.editor().plan().orElseThrow();
        Additions.Preview preview = context.additions().preview(suggestion.edit());
        preview.planned()
                .ifPresent(planned -> context.preview()
                        .show(
                                planned,
                                PlanComparison.of(plan, planned, context.vocabulary())
                                        .changes()));
        List<AuthorQuestion.Choice> choices = new ArrayList<>();
        choices.add(choice("apply", "Write it", () -> {
            end();
            context.apply(suggestion.edit());
        }));
        int count = result.suggestions().size();
        if (at + 1 < count) {
            choices.add(choice("next", "Next", () -> show(result, at + 1)));
        }
        if (at > 0) {
            choices.add(choice("back", "Back", () -> show(result, at - 1)));
        }
        choices.add(choice("leave", "Leave it", this::end));
        ask((at + 1) + " of " + count + ": " + suggestion.words() + ". " + effect(suggestion), choices);
    }

    private static String effect(Suggestion suggestion) {
        List<String> lines = new ArrayList<>(List.of(suggestion.balance()));
        lines.addAll(suggestion.mended());
        suggestion.caused().forEach(line -> lines.add("but " + line));
        return String.join("; ", lines);
    }

    private static AuthorQuestion.Choice choice(String id, String label, Runnable chosen) {
        return new AuthorQuestion.Choice(ID + "-" + id, label, chosen);
    }

    private void ask(String text, List<AuthorQuestion.Choice> choices) {
        isShown = true;
        context.questions().ask(new AuthorQuestion(ID, text, choices, this::end));
    }

    private void end() {
        running.ifPresent(search -> search.set(true));
        running = Optional.empty();
        if (isShown) {
            isShown = false;
            context.preview().clear();
            context.questions().withdraw(ID);
        }
    }
}
