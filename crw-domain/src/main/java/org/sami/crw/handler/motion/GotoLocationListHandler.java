package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;

/**
 * Proxy Goto Location List: each boat goes to the first location of its list where it has not been in this mission, one at each entry.
 * A boat that has been at all of them, or has no list, completes its list at once.
 */
public final class GotoLocationListHandler implements ActivationHandler {
    public static final String TYPE = "ProxyGotoLocationList";
    private static final String LOCATIONS = "locations";

    private final MotionCommands motion;

    public GotoLocationListHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Map<String, ListValue> lists =
                ProxyMaps.read(ActivationFields.required(activation, LOCATIONS), ListValue.class);
        List<Move> moves = new ArrayList<>();
        List<Input> done = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            List<GeoPoint> list = Optional.ofNullable(lists.get(addressee.boat()))
                    .map(value -> ActivationFields.points(value, LOCATIONS))
                    .orElse(List.of());
            String key = PathProgress.listKey(addressee.boat(), list);
            int next = PathProgress.visited(context, activation.mission(), key, list.size());
            if (next == list.size()) {
                done.add(new Input.Received(addressee.answer(EventNames.LIST_COMPLETED, activation, Map.of())));
            } else {
                FollowPath command = FollowPath.goTo(
                        Move.commandId(activation, addressee),
                        activation.mission(),
                        activation.id(),
                        list.get(next),
                        activation.priority());
                moves.add(new Move(addressee, command, Optional.of(new PathProgress.Along(key, next)), Reply.WAY));
            }
        }
        motion.send(activation, context, moves);
        if (!done.isEmpty()) {
            context.post(done);
        }
    }
}
