package org.sami.crw.decision;

import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.markup.Attention;
import org.sami.crw.markup.MapRelevance;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/**
 * A decision for display, with its markups applied (appendix .2.3). Windows, the console and the simulated operator ask from this alone
 * (docs/decisions-model.md). Immutable; made by {@link DecisionPresenter}.
 *
 * @param decision with the question as it is asked
 * @param boats the boats that it concerns: those of the activation that asks or is asked about, or the boat that the domain asks about; none
 *     where it concerns none, or that is unknown
 * @param description lines by the author, the place about which an event asks yes or no, and the names of plan, vertex and event where the markup Description shows them
 * @param options the options, filtered and sorted; empty for yes or no and for values
 * @param format layout of the options (markup Selection Options)
 * @param attention how the decision draws attention; empty where it does not
 * @param proposedLocation the proposal where a location is asked for; empty without one
 * @param map what it concerns on the map
 * @param approved what is to be approved or not and has places, such as the path of each robot; empty for other questions
 */
public record DecisionPresentation(
        Decision decision,
        Asker asker,
        List<String> boats,
        List<String> description,
        List<OfferedOption> options,
        OptionsFormat format,
        MixedInitiative autonomy,
        Optional<Attention> attention,
        Optional<LocationDefault> proposedLocation,
        MapRelevance map,
        List<Value> approved) {
    /** How options are laid out. */
    public enum OptionsFormat {
        /** One after the other. */
        SEQUENTIAL,
        /** All below each other. */
        STACKED,
        /** Each in a tab. */
        TABS
    }

    /** Which location is proposed. */
    public enum LocationDefault {
        /** Where boats are launched. */
        QUAY,
        /** The middle of the area of operation. */
        AREA
    }

    public DecisionPresentation {
        Objects.requireNonNull(decision, "decision");
        Objects.requireNonNull(asker, "asker");
        boats = List.copyOf(boats);
        description = List.copyOf(description);
        options = List.copyOf(options);
        Objects.requireNonNull(format, "format");
        Objects.requireNonNull(autonomy, "autonomy");
        Objects.requireNonNull(attention, "attention");
        Objects.requireNonNull(proposedLocation, "proposedLocation");
        Objects.requireNonNull(map, "map");
        approved = List.copyOf(approved);
    }

    /** Names the decision. */
    public long id() {
        return decision.id();
    }

    /** What is asked, in one sentence; of an event that has no question of its own the name of the place that asks. */
    public String title() {
        return isNamedByItsPlace() ? asker.placeName() : decision.prompt();
    }

    /** Whether nothing but the place says what is asked. */
    public boolean isNamedByItsPlace() {
        String ofTheEngine = asker.event() + " (" + asker.placeName() + ")";
        return !asker.placeName().isEmpty() && decision.prompt().equals(ofTheEngine);
    }

    /** What form the answer has. */
    public Question question() {
        return decision.question();
    }

    /** How urgent it is. */
    public Priority priority() {
        return decision.priority();
    }

    /**
     * The answer that chooses some of the options.
     *
     * @throws IllegalArgumentException for more or less than one where one of several options is asked for, or where there are no options
     */
    public Answer choosing(Collection<OfferedOption> chosen) {
        if (question() instanceof Question.ChooseProxies) {
            return new Answer.Proxies(chosen.stream()
                    .map(choice -> ((ProxyValue) choice.value()).proxy())
                    .toList());
        }
        if (question() instanceof Question.ChooseOption && chosen.size() == 1) {
            return new Answer.Option(chosen.iterator().next().index());
        }
        throw new IllegalArgumentException("One option is to be chosen, not " + chosen.size());
    }

    /** The answer that takes what is selected when the decision opens; empty where nothing is. */
    public Optional<Answer> selected() {
        List<OfferedOption> preset =
                options.stream().filter(OfferedOption::selected).toList();
        return preset.isEmpty() ? Optional.empty() : Optional.of(choosing(preset));
    }

    /** The same, after something of the decision itself has changed, such as its deadline. */
    public DecisionPresentation withDecision(Decision changed) {
        return new DecisionPresentation(
                changed,
                asker,
                boats,
                description,
                options,
                format,
                MixedInitiative.of(changed, autonomy.words()),
                attention,
                proposedLocation,
                map,
                approved);
    }
}
