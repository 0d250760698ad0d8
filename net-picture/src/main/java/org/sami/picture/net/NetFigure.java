package org.sami.picture.net;

/**
 * A net as it is painted.
 *
 * @param scene what of it is shown
 * @param marking the tokens in its places
 * @param badges the signs at its vertices
 * @param light what of it is shown in other colours than usual
 */
public record NetFigure(NetScene scene, NetMarking marking, NetBadges badges, NetLight light) {
    /** A net alone: no tokens, no signs, nothing selected. */
    public static NetFigure of(NetScene scene) {
        return new NetFigure(scene, NetMarking.EMPTY, NetBadges.NONE, NetLight.NONE);
    }
}
