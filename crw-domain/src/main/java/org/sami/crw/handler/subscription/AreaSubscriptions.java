package org.sami.crw.handler.subscription;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator;
import org.locationtech.jts.algorithm.locate.PointOnGeometryLocator;
import org.locationtech.jts.geom.Location;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Proxy Area Subscription (thesis Fig. 7.4): reports at once which boats that entered the place are in an area, and then each that enters or leaves
 * the area while it stands in the place. The border belongs to the area. The mission's memory keeps the last report, so that a restarted base repeats
 * none. For the fleet's thread; it passes the engine's steps on to it.
 */
public final class AreaSubscriptions implements ActivationHandler, Consumer<FleetEvent>, HostListener {
    public static final String TYPE = "ProxyAreaSubscription";
    private static final String AREA = "area";

    private final ProxyRegistry boats;
    private final OpenSubscriptions<Subscription> open;

    public AreaSubscriptions(ProxyRegistry boats, Executor fleet) {
        this.boats = boats;
        open = new OpenSubscriptions<>(fleet, subscription -> subscription.byBoat.isEmpty());
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, AREA) instanceof GeoArea area)) {
            throw new IllegalArgumentException("\"" + AREA + "\" is no area: " + activation.value(AREA));
        }
        Subscription subscription = new Subscription(activation, context, area);
        open.add(activation.id(), subscription);
        for (String boat : List.copyOf(subscription.byBoat.keySet())) {
            boats.find(boat)
                    .flatMap(proxy -> proxy.status().pose())
                    .ifPresent(pose -> subscription.at(boat, pose.position()));
        }
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        }
    }

    private void onStatus(BoatStatus status) {
        status.pose().ifPresent(pose -> open.tell(subscription -> subscription.at(status.boatId(), pose.position())));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        open.onStep(index, atMillis, input, effects, view);
    }

    /** One activation, its area on a plane, and where each of its boats was last: inside or not. */
    private static final class Subscription {
        private final Activation activation;
        private final HandlerContext context;
        private final LocalPlane plane;
        private final PointOnGeometryLocator area;
        private final Map<String, Addressee> byBoat = new LinkedHashMap<>();
        private final Map<String, Boolean> inside = new LinkedHashMap<>();

        Subscription(Activation activation, HandlerContext context, GeoArea area) {
            this.activation = activation;
            this.context = context;
            plane = new LocalPlane(area.outline().get(0));
            this.area = new IndexedPointInAreaLocator(Areas.polygon(area, plane, "the area"));
            for (Addressee addressee : Addressee.of(activation, context)) {
                byBoat.put(addressee.boat(), addressee);
                inside.put(addressee.boat(), told(addressee.boat()));
            }
        }

        private boolean told(String boat) {
            return context.query(view -> view.memory(activation.mission(), key(boat)))
                    .filter(new BooleanValue(true)::equals)
                    .isPresent();
        }

        private String key(String boat) {
            return "area/" + activation.id() + "/" + boat;
        }

        void at(String boat, GeoPoint position) {
            Addressee addressee = byBoat.get(boat);
            if (addressee == null) {
                return;
            }
            boolean now = area.locate(Areas.coordinate(position, plane)) != Location.EXTERIOR;
            if (now == Objects.requireNonNull(inside.get(boat), boat)) {
                return;
            }
            if (!addressee.stands(activation, context)) {
                byBoat.remove(boat);
                return;
            }
            inside.put(boat, now);
            String news = now ? EventNames.ENTERED_AREA : EventNames.LEFT_AREA;
            context.post(List.of(
                    new Input.Remember(activation.mission(), key(boat), new BooleanValue(now)),
                    new Input.Received(addressee.answer(news, activation, Map.of()))));
        }
    }
}
