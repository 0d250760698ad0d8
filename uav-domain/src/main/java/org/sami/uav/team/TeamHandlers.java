package org.sami.uav.team;

import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModule;
import org.sami.crw.handler.HandlerParts;

/** The handlers of the domain that combines boats and aircraft, in addition to theirs. */
public final class TeamHandlers implements HandlerModule {
    @Override
    public String domain() {
        return "team";
    }

    @Override
    public RobotKind robots() {
        return RobotKind.ROBOT;
    }

    @Override
    public void addTo(HandlerParts parts) {
        parts.add(SelectCapableHandler.TYPE, new SelectCapableHandler(parts.robots(), parts.messages()));
    }
}
