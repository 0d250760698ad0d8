package org.sami.boat.server;

import org.sami.boat.link.LostLinkAction;

/** An event that can change the mode of a boat: a message of its commander, the loss of the link, or what the boat notices itself. */
enum ModeEvent {
    /** The commander replaces the waypoint list. */
    UPLOAD,
    /** The commander starts the waypoint list. */
    START,
    /** The commander starts the waypoint list behind its last waypoint. */
    START_AT_END,
    /** The commander makes the boat keep station. */
    HOLD_POSITION,
    /** The commander makes the boat turn all round and take pictures. */
    PANORAMA,
    /** The commander drives by hand. */
    TELEOPERATE,
    /** The commander stops the motors. */
    STOP_MOTORS,
    /** The commander stops the whole fleet. */
    FLEET_STOP,
    /** The commander releases the fleet stop. */
    FLEET_RELEASE,
    /** The link is lost and {@link LostLinkAction#HOLD} is set. */
    LINK_LOST_HOLD,
    /** The link is lost and {@link LostLinkAction#RETURN} is set. */
    LINK_LOST_RETURN,
    /** The link is lost and {@link LostLinkAction#CONTINUE} is set. */
    LINK_LOST_CONTINUE,
    /** The link is lost and {@link LostLinkAction#DRIFT} is set. */
    LINK_LOST_DRIFT,
    /** The boat has reached the last waypoint of its list. */
    PATH_DONE,
    /** The boat has reached its home position. */
    HOME_REACHED,
    /** The commander has not set the motors for longer than the configured time. */
    HAND_SILENT;

    /** The link is lost while an action is set. */
    static ModeEvent linkLost(LostLinkAction action) {
        return valueOf("LINK_LOST_" + action.name());
    }
}
