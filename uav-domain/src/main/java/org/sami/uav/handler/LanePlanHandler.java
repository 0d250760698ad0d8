package org.sami.uav.handler;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.HandlerParts;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.Restrictions;
import org.sami.crw.handler.planning.Computations;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** Plan Lanes: divides an area among the aircraft that entered, each with lanes to fly, and answers with the paths. Nobody flies yet. */
final class LanePlanHandler implements ActivationHandler {
    private final HandlerParts parts;
    private final Flights flights;

    LanePlanHandler(HandlerParts parts, Flights flights) {
        this.parts = parts;
        this.flights = flights;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) throws Exception {
        GeoArea area = Restrictions.area(ActivationFields.required(activation, "area"), "area");
        double spacingM = ActivationFields.metres(activation, "spacing");
        double altM = Flights.number(activation, "altitude", Flights.ALTITUDE_M);
        List<Addressee> aircraft = Addressee.of(activation, context);
        Map<String, Optional<GeoPoint>> from = new LinkedHashMap<>();
        aircraft.forEach(one -> from.put(one.boat(), flights.position(one.boat())));
        CoverageProblem problem = new CoverageProblem(
                from,
                area,
                spacingM,
                context.query(view -> PlanAreas.avoided(activation, view)),
                context.query(view -> PlanAreas.within(activation, view)),
                parts.errors().of(List.copyOf(from.keySet())));
        parts.computations().compute(activation, context, new Computations.Task<Coverage>() {
            @Override
            public String what() {
                return "the division of the area";
            }

            @Override
            public Coverage compute() {
                return parts.services().coverage().cover(problem);
            }

            @Override
            public void found(Coverage coverage) {
                Map<String, GeoPath> paths = new LinkedHashMap<>();
                coverage.shares()
                        .forEach((name, share) -> paths.put(
                                name,
                                new GeoPath(flights.raised(name, share.path().points(), altM))));
                context.post(new Input.Received(Occurrence.answer(
                        UavEvents.LANES_PLANNED,
                        activation,
                        aircraft.stream().map(Addressee::boat).toList(),
                        List.of(),
                        Map.of("paths", ProxyMaps.toValue(paths)))));
            }
        });
    }
}
