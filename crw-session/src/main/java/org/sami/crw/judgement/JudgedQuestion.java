package org.sami.crw.judgement;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.session.api.DraftAnswer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;

/**
 * The criteria for the answers to a question, from the engine's present state. Immutable.
 *
 * @param requests output events whose fields the answer fills
 * @param next output events at which chosen boats arrive next
 * @param limits no-go areas of the mission's plan and the project, and the area in which its boats stay
 * @param area the project's fence and no-go areas
 * @param swaps whether the plans provide for battery swaps on the way
 * @param boats the boats that would go unless the answer chooses some: those of the mission, or all
 */
public record JudgedQuestion(
        Question question,
        List<JudgedRequest> requests,
        List<JudgedRequest> next,
        WayLimits limits,
        OperatingArea area,
        boolean swaps,
        List<String> boats) {
    public JudgedQuestion {
        Objects.requireNonNull(question, "question");
        requests = List.copyOf(requests);
        next = List.copyOf(next);
        Objects.requireNonNull(limits, "limits");
        Objects.requireNonNull(area, "area");
        boats = List.copyOf(boats);
    }

    /** The boats that would go by a draft of the answer. */
    public List<String> boats(DraftAnswer draft) {
        return question instanceof Question.ChooseProxies ? draft.boats() : boats;
    }

    /** The area to stay in: of the plan's requests, else the project's fence. */
    Optional<GeoArea> stay() {
        return limits.within().or(area::fence);
    }

    /** What people call an area to stay in. */
    String name(GeoArea within) {
        return area.fence().filter(within::equals).isPresent() ? "the fence" : "the area in which the mission stays";
    }

    /** What people call the areas that are avoided. */
    String avoided() {
        return isNoGo() ? "no-go areas" : "areas that are to be avoided";
    }

    /** What people call one of them. */
    String avoidedOne() {
        return isNoGo() ? "a no-go area" : "an area that is to be avoided";
    }

    private boolean isNoGo() {
        return area.noGo().containsAll(limits.avoid());
    }

    /** Whether an item gives an area that limits boats, rather than one for work. */
    boolean isLimit(String item) {
        return item.equals(OperatingArea.FENCE)
                || item.equals(OperatingArea.NO_GO)
                || requests.stream()
                        .flatMap(request -> request.fieldsOf(item).stream())
                        .anyMatch(field -> field.equals(JudgedRequest.WITHIN) || field.equals(JudgedRequest.AVOID));
    }
}
