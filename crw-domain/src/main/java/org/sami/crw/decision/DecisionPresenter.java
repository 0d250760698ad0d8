package org.sami.crw.decision;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.crw.decision.DecisionPresentation.LocationDefault;
import org.sami.crw.decision.DecisionPresentation.OptionsFormat;
import org.sami.crw.markup.Attention;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MarkupReader;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventType;

/** Makes {@link DecisionPresentation}s: asks the engine's state for what a decision does not say itself. */
public final class DecisionPresenter {
    private static final String DESCRIPTION = "Description";
    private static final String AT = "at"; // the field of events that ask about a place

    private DecisionPresenter() {}

    /** How a decision is to be shown that is open, or was in this step. On the engine's thread. */
    public static DecisionPresentation of(Decision asked, EngineView view) {
        Decision decision = ProposedLocation.in(asked, view.globals());
        Optional<AskedActivation> about = view.subject(decision.id()).flatMap(AskedActivation::of);
        Optional<Activation> asking =
                view.activation(about.map(AskedActivation::activation).orElse(decision.activation()));
        long mission = about.map(AskedActivation::mission).orElse(decision.mission());
        MarkupReader markups = new MarkupReader(decision.markups());
        List<String> all = view.proxies();
        List<OfferedOption> choices = OfferedOptions.of(
                decision, markups, all, boat -> BoatDescriptions.of(view, boat).orElse(""));
        return of(
                decision,
                asker(mission, asking, view),
                markups,
                place(decision, asking),
                choices,
                asking.map(Activation::proxies)
                        .orElseGet(() -> view.subject(decision.id())
                                .filter(all::contains)
                                .map(List::of)
                                .orElseGet(() -> offeredByDomain(decision))),
                all,
                decision.question() instanceof Question.Approve
                        ? asking.map(ApprovedPlaces::of).orElse(List.of())
                        : List.of());
    }

    /** The boats among which the operator chooses where no plan asks. */
    private static List<String> offeredByDomain(Decision decision) {
        return DomainQuestion.of(decision.type()).isPresent()
                        && decision.question() instanceof Question.ChooseProxies choice
                ? choice.proxies()
                : List.of();
    }

    /** A decision of which nothing is known but what it says itself. */
    public static DecisionPresentation plain(Decision decision) {
        MarkupReader markups = new MarkupReader(decision.markups());
        List<OfferedOption> options = OfferedOptions.of(decision, markups, List.of(), boat -> "");
        return of(decision, Asker.UNKNOWN, markups, Optional.empty(), options, List.of(), List.of(), List.of());
    }

    private static DecisionPresentation of(
            Decision decision,
            Asker asker,
            MarkupReader markups,
            Optional<String> place,
            List<OfferedOption> choices,
            List<String> relevant,
            List<String> all,
            List<Value> approved) {
        String words = decision.automatic()
                .map(answer -> OfferedOptions.words(answer, choices))
                .orElse("");
        return new DecisionPresentation(
                decision,
                asker,
                relevant,
                description(markups, asker, place),
                choices,
                markups.constant("SelectionOptions", "format", OptionsFormat.class)
                        .orElse(OptionsFormat.SEQUENTIAL),
                MixedInitiative.of(decision, words),
                Attention.of(markups),
                markups.constant("DefaultLocation", "location", LocationDefault.class),
                MapRelevance.of(markups, relevant, all),
                approved);
    }

    private static Asker asker(long asks, Optional<Activation> asking, EngineView view) {
        Optional<MissionView> mission = view.mission(asks);
        Optional<Plan> plan = view.planOf(asks);
        Optional<Place> place = asking.flatMap(a -> plan.flatMap(known -> known.place(a.place())));
        return new Asker(
                mission.map(MissionView::plan).orElse(""),
                plan.map(Plan::title).orElse(""),
                mission.map(MissionView::name).orElse(""),
                asking.map(Activation::place).orElse(""),
                place.map(Place::name)
                        .filter(name -> !name.isBlank())
                        .or(() -> asking.map(Activation::place))
                        .orElse(""),
                asking.map(a -> view.vocabulary()
                                .event(a.type())
                                .map(EventType::label)
                                .orElse(a.type()))
                        .orElse(""));
    }

    /** Where on the map that is about which an event asks yes or no; empty where it is about no place. */
    private static Optional<String> place(Decision decision, Optional<Activation> asking) {
        return asking.filter(event -> decision.question() instanceof Question.Approve)
                .flatMap(event -> event.value(AT))
                .filter(GeoPoint.class::isInstance)
                .map(GeoPoint.class::cast)
                .map(at -> String.format(Locale.ROOT, "At %.5f,%.5f", at.latDeg(), at.lonDeg()));
    }

    private static List<String> description(MarkupReader markups, Asker asker, Optional<String> place) {
        List<String> lines = new ArrayList<>();
        lines.add(markups.text(DESCRIPTION, "source"));
        place.ifPresent(lines::add);
        if (markups.flag(DESCRIPTION, "showPlanName")) {
            lines.add("Plan: " + asker.planTitle());
        }
        if (markups.flag(DESCRIPTION, "showVertexName")) {
            lines.add("Place: " + asker.placeName());
        }
        if (markups.flag(DESCRIPTION, "showEventName")) {
            lines.add("Event: " + asker.event());
        }
        lines.removeIf(String::isBlank);
        return lines;
    }
}
