package org.sami.crw.area;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * The operating area of a session's boats: inside the fence and outside the no-go areas (docs/operator-models.md). Immutable.
 *
 * @param fence the area to stay in; empty without one
 * @param noGo areas that boats may not enter
 * @param byHand whether the operator, and not the project, set or removed the fence
 */
public record OperatingArea(Optional<GeoArea> fence, List<GeoArea> noGo, boolean byHand) {
    /** The global variable that holds the fence. */
    public static final String FENCE = "@water";

    /** The global variable that holds the no-go areas. */
    public static final String NO_GO = "@noGo";

    /** The key by which the session's journal remembers a fence that was set by hand. */
    public static final String MEMORY = "operator/fence";

    private static final TextValue NO_FENCE = new TextValue("none");
    private static final TextValue PROJECT = new TextValue("project");

    /** No fence and nothing that is forbidden. */
    public static final OperatingArea OPEN = new OperatingArea(Optional.empty(), List.of(), false);

    public OperatingArea {
        noGo = List.copyOf(noGo);
    }

    /** The area as it stands. */
    public static OperatingArea of(EngineView view) {
        return of(view.globals(), view.memory(Ids.NONE, MEMORY));
    }

    /**
     * The area that a project's variables and the operator say.
     *
     * @param remembered what the operator set last; empty if nothing
     */
    public static OperatingArea of(Map<String, Value> globals, Optional<Value> remembered) {
        List<GeoArea> noGo = areas(Optional.ofNullable(globals.get(NO_GO)));
        if (remembered.isPresent() && remembered.get() instanceof GeoArea area) {
            return new OperatingArea(Optional.of(area), noGo, true);
        } else if (remembered.filter(NO_FENCE::equals).isPresent()) {
            return new OperatingArea(Optional.empty(), noGo, true);
        }
        Optional<GeoArea> project =
                areas(Optional.ofNullable(globals.get(FENCE))).stream().findFirst();
        return new OperatingArea(project, noGo, false);
    }

    /** All areas in a value. */
    public static List<GeoArea> areas(Optional<Value> value) {
        List<GeoArea> areas = new ArrayList<>();
        if (value.isPresent() && value.get() instanceof GeoArea area) {
            areas.add(area);
        } else if (value.isPresent() && value.get() instanceof ListValue list) {
            list.items().forEach(item -> areas.addAll(areas(Optional.of(item))));
        }
        return areas;
    }

    /** What sets a fence by hand. */
    public static Input remember(GeoArea fence) {
        return new Input.Remember(Ids.NONE, MEMORY, fence);
    }

    /** What takes every fence away. */
    public static Input rememberNone() {
        return new Input.Remember(Ids.NONE, MEMORY, NO_FENCE);
    }

    /** What makes the project's fence count again. */
    public static Input rememberProject() {
        return new Input.Remember(Ids.NONE, MEMORY, PROJECT);
    }

    /** What an input remembers of the fence; empty where it is about something else. */
    public static Optional<Value> remembered(Input input) {
        return input instanceof Input.Remember remember
                        && remember.mission() == Ids.NONE
                        && remember.key().equals(MEMORY)
                ? Optional.of(remember.value())
                : Optional.empty();
    }

    /**
     * The water in which boats may go; empty where they may go everywhere.
     *
     * @throws IllegalArgumentException for an area that is no simple polygon
     */
    public Optional<Water> water() {
        Optional<GeoPoint> origin = fence.or(() -> noGo.stream().findFirst())
                .map(area -> area.outline().get(0));
        return origin.map(near -> Water.of(near, noGo, fence));
    }
}
