// The page that --view writes: shows its own data.
import { start } from './main.js';

start();
