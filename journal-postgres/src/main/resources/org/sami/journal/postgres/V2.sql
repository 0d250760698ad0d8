-- Whether a standby on another machine may take the session over by itself once it no longer sees the lease renewed: the holder counts on it then.
ALTER TABLE lease ADD COLUMN standby_may_take boolean NOT NULL DEFAULT false;
