package org.sami.crw.decision;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;

/**
 * The markup Filter on a choice of boats: offers those, or all but those, whose name or description contains a text, without regard to case
 * (thesis 6.3.2). Where that leaves fewer boats than must be chosen, all are offered: a question that nobody could answer would
 * stop its mission.
 */
public final class BoatFilter {
    private static final String MARKUP = "Filter";

    private BoatFilter() {}

    /** The decision as it is to be shown, with the descriptions that boats have now. */
    public static Decision narrowed(Decision decision, EngineView view) {
        return narrowed(decision, boat -> BoatDescriptions.of(view, boat));
    }

    static Decision narrowed(Decision decision, Function<String, Optional<String>> descriptionOf) {
        if (!(decision.question() instanceof Question.ChooseProxies choice)) {
            return decision;
        }
        List<String> offered = choice.proxies();
        for (MarkupSpec markup : decision.markups()) {
            if (markup.type().equals(MARKUP)) {
                Predicate<String> contained = contained(markup, descriptionOf);
                offered = offered.stream().filter(contained).toList();
            }
        }
        if (offered.size() == choice.proxies().size() || offered.isEmpty() || offered.size() < choice.min()) {
            return decision;
        }
        return decision.asking(new Question.ChooseProxies(offered, choice.min(), choice.max()));
    }

    private static Predicate<String> contained(MarkupSpec markup, Function<String, Optional<String>> descriptionOf) {
        String wanted = markup.option("source")
                .filter(TextValue.class::isInstance)
                .map(value -> fold(((TextValue) value).value()))
                .orElse("");
        boolean exclude = markup.option("action")
                .filter(value ->
                        value instanceof EnumValue action && action.constant().equals("EXCLUDE"))
                .isPresent();
        return boat -> exclude
                != (fold(boat).contains(wanted)
                        || descriptionOf
                                .apply(boat)
                                .filter(text -> fold(text).contains(wanted))
                                .isPresent());
    }

    private static String fold(String text) {
        return text.toLowerCase(Locale.ROOT);
    }
}
